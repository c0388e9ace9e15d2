// Two films: the box that tumbles, and the capsule on the plane.

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <timestep/rigid/exact_free_body.hpp>

#include "picture.hpp"
#include "plane_solvers.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

using V = Vector3<double>;
constexpr double rate = 60;  // steps a second, whatever the step of the rest of the run

std::string words(const char* form, double value) {
    char text[64];
    std::snprintf(text, sizeof text, form, value);
    return text;
}

// A box with sides 1:2:3, spun about its middle axis, which points up; orange end up, blue end
// down.
void tumbling(lab::Findings& out) {
    const PrincipalInertia<double> inertia = box(1.0, 1.0, 2.0, 3.0);
    const auto faces = picture::box(0.33, 0.66, 1.0);
    const Quaternion<double> upright(Eigen::AngleAxisd(picture::degrees(90), V::UnitX()));
    const RigidState<double> start{0, upright, upright * V(0.05, 7, 0.05)};
    const ExactFreeBody<double> exact(inertia, start);
    std::array<RigidState<double>, 4> now;
    now.fill(start);

    picture::Film film(out, "tumbling.tsv");
    auto& captions = out.table("tumbling_captions.tsv", {"t", "exact", "dropped", "implicit", "passive"});
    const V origin(0, 0, 0);
    constexpr int frames = 150, steps = 4;
    std::array<std::vector<double>, 4> flips;  // the times at which the spin about the middle axis turns over
    std::array<double, 4> before{};
    for (int frame = 0; frame < frames; ++frame) {
        std::vector<lab::Cell> caption{words("t = %.1f s", frame * steps / rate)};
        for (int i = 0; i < 4; ++i) {
            film.body(faces, now[i].q, origin, origin, 1.26 * (i - 1.5));
            caption.push_back(words("E = %.2f", kinetic_energy(inertia, now[i]) / kinetic_energy(inertia, start)));
        }
        film.frame_ends();
        captions.row(caption);
        for (int n = 1; n <= steps; ++n) {
            now[0] = exact((frame * steps + n) / rate);
            now[1] = solver("dropped").turn(inertia, now[1], 1 / rate);
            now[2] = solver("implicit").turn(inertia, now[2], 1 / rate);
            now[3] = solver("passive").turn(inertia, now[3], 1 / rate);
            for (int i = 0; i < 4; ++i) {
                // Dropped, ω stands still in the world and in the body: no flip, ever.
                const double middle = (now[i].q.conjugate() * now[i].omega).y();
                if (middle * before[i] < 0) flips[i].push_back(now[i].t);
                before[i] = middle;
            }
        }
    }
    out.number("tumbling_spin", 7, "rad/s", "spin of the box in the tumbling film");
    const char* names[] = {"exact", "dropped", "implicit", "passive"};
    for (int i = 0; i < 4; ++i) {
        const std::string name = names[i];
        out.number("tumbling_" + name + "_energy", kinetic_energy(inertia, now[i]) / kinetic_energy(inertia, start), "",
                   name + ": energy at the end of the film over that at its start", 2);
    }
    const V last = now[3].q.conjugate() * now[3].omega;
    out.check(
        "tumbling_film",
        flips[0].size() == 3 && flips[2].size() == 3 && flips[1].empty() && std::fabs(flips[0][2] - flips[2][2]) < 0.1,
        "in the film the implicit box flips when the exact one does, and the dropped one never");
    out.check("tumbling_passive", flips[3].size() > 3 && std::fabs(last.x()) > 0.99 * last.norm(),
              "in the film the passive box ends up spinning about its shortest side");
}

// The capsule of capsule_on_plane, with rolling resistance and the arms of engines, at half speed.
void on_plane(lab::Findings& out) {
    const auto body = scene::capsule();
    const auto faces = picture::capsule(body.radius, body.half_length);
    const plane::Ground ground = scene::ground(0.1, plane::Arms::start);
    picture::Film film(out, "capsule.tsv");
    auto& captions = out.table("capsule_captions.tsv", {"t", "explicit", "dropped", "passive"});
    std::array<plane::BodyState, 3> now;
    now.fill(scene::thrown(body));
    std::array<bool, 3> lost{};
    constexpr int frames = 150, steps = 2;
    for (int frame = 0; frame < frames; ++frame) {
        std::vector<lab::Cell> caption{words("t = %.1f s", frame * steps / rate)};
        for (int i = 0; i < 3; ++i) {
            const plane::BodyState& m = now[i];
            const double spin = m.turning.omega.norm();
            lost[i] = lost[i] || !(spin < 200) || m.x.z() > 1.2;
            const V origin = lost[i] ? V(V::Zero()) : V(m.x.x(), m.x.y(), 0);
            const double shift = 1.35 * (i - 1);
            film.floor(origin, 0.6, 0.3, shift);
            if (lost[i]) {
                caption.push_back("blown up");
                continue;
            }
            std::vector<V> shade;
            for (int k = 0; k < 36; ++k) {  // the outline of two discs: each point is of the further one
                const V out_there(std::cos(picture::degrees(10 * k)), std::sin(picture::degrees(10 * k)), 0);
                const V e = body.end(m.turning.q, 0), f = e.dot(out_there) > 0 ? e : V(-e);
                shade.push_back(V(m.x.x() + f.x(), m.x.y() + f.y(), 0) + body.radius * out_there);
            }
            film.polygon(shade, origin, shift, picture::shadow);
            film.body(faces, m.turning.q, m.x, origin, shift);
            caption.push_back(spin < 0.01 ? std::string("at rest") : words("%.0f rad/s", spin));
        }
        film.frame_ends();
        captions.row(caption);
        plane::Contacts contacts;
        const auto advance = [&](const char* key, int i) {
            for (int n = 0; n < steps && !lost[i]; ++n)
                now[i] = scene::plane_solver(key).step(body, ground, now[i], 1 / rate, contacts);
        };
        advance("explicit", 0);
        advance("dropped", 1);
        advance("passive", 2);
    }
    out.check("capsule_film", lost[0] && now[1].turning.omega.norm() > 10 && now[2].turning.omega.norm() < 0.01,
              "in the film the explicit capsule is lost, the dropped one spins, the passive one "
              "lies still");
}

}  // namespace

void films(const Settings&, lab::Findings& out) {
    tumbling(out);
    on_plane(out);
}
