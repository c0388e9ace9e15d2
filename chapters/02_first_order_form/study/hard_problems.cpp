// Problems without a simple answer: drag, and a tether in space.

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <Eigen/Geometry>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/models/tether.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

// Where the path comes down through the height of the hand: the line between the two states on
// either side tells.
struct Landing {
    double x = 0;
    bool found = false;
    State<Vector2> before = throw_grenade();

    void look(const State<Vector2>& s) {
        if (!found && before.x.y() > 0 && s.x.y() <= 0) {
            const double part = before.x.y() / (before.x.y() - s.x.y());
            x = before.x.x() + part * (s.x.x() - before.x.x());
            found = true;
        }
        before = s;
    }
};

constexpr double longest = 2 * throw_speed / gravity;  // no drag lengthens a flight

template <class Method, class Model>
Landing fly(const Method& method, const Model& model, double h, lab::Table* path = nullptr) {
    Landing landing;
    run(method, model, throw_grenade(), h, std::lround(longest / h), [&](const State<Vector2>& s) {
        if (path && !landing.found) path->row({s.x.x(), s.x.y()});
        landing.look(s);
    });
    return landing;
}

// How many steps a second are enough to know where the grenade is after three seconds, to a
// centimetre: the least whole number.
template <class Method, class Model>
double rate_needed(const Method& method, const Model& model, const Vector2& mark) {
    for (long a_second = 1; a_second < 10000; ++a_second) {
        const State<Vector2> s = run(method, model, throw_grenade(), 1.0 / a_second, 3 * a_second);
        if ((s.x - mark).norm() < 0.01) return a_second;
    }
    throw std::runtime_error("no step was small enough for a centimetre");
}

void drag(const Settings& settings, lab::Findings& out) {
    const auto model = grenade(settings);
    const double fine = 1.0 / 2048;
    const auto columns = {std::string("x"), std::string("y")};
    const Landing vacuum =
        fly(runge_kutta_4, Projectile{Vector2(0, -gravity)}, fine, &out.table("path_vacuum.tsv", columns));
    const Landing air = fly(runge_kutta_4, model, fine, &out.table("path_drag.tsv", columns));
    const Landing coarse = fly(explicit_euler, model, 0.1, &out.table("path_euler.tsv", columns));
    std::printf("  the grenade lands at %.2f m; without air it would at %.2f m\n", air.x, vacuum.x);
    std::printf("  explicit Euler at 10 steps a second misses the mark by %.2f m\n", coarse.x - air.x);
    out.number("range_drag", air.x, "m", "where the grenade lands", 4);
    out.number("range_vacuum", vacuum.x, "m", "where it would land without air", 4);
    out.number("euler_misses", coarse.x - air.x, "m", "by how much explicit Euler overshoots at 10 Hz");
    out.number("terminal_speed", settings.terminal_speed, "m/s", "the grenade's speed in a long fall");
    out.check("drag_shortens", air.x < vacuum.x, "with drag the grenade lands short");

    const Vector2 mark = run(runge_kutta_4, model, throw_grenade(), fine, 3 * 2048).x;
    const double euler = rate_needed(explicit_euler, model, mark);
    const double rk4 = rate_needed(runge_kutta_4, model, mark);
    std::printf(
        "  to know its place after 3 s to 1 cm, explicit Euler evaluates\n"
        "  the forces %g times a second, RK4 %g times\n",
        euler, 4 * rk4);
    auto& table = out.table("cost.tsv", {"method", "steps a second", "evaluations a step", "evaluations a second"});
    table.row({"explicit Euler", euler, 1.0, euler});
    table.row({"RK4", rk4, 4.0, 4 * rk4});
    out.check("rk4_cheaper_for_1cm", 4 * rk4 < euler,
              "to know the grenade's place to a centimetre, RK4 needs fewer evaluations");
}

// How far the angular momentum x × v strays from its start.
double momentum_error(const Tether<double>& tether, const State<Vector3>& start, double h, long steps) {
    const Vector3 at_start = start.x.cross(start.v);
    double worst = 0;
    run(runge_kutta_4, tether, start, h, steps, [&](const State<Vector3>& s) {
        worst = std::max(worst, (s.x.cross(s.v) - at_start).norm() / at_start.norm());
    });
    return worst;
}

void tether(lab::Findings& out) {
    const Tether rope(6.0, 1.0);  // rad/s along the rope, and 1 m long at rest
    const State start{0, Vector3(1.6, 0, 0.4), Vector3(0, 3, 1.5)};
    const double seconds = 8;
    auto& orbit = out.table("orbit_tether.tsv", {"x", "y", "z"});
    run(runge_kutta_4, rope, start, 1.0 / 256, 256L * 8, [&](const State<Vector3>& s) {
        orbit.row({s.x.x(), s.x.y(), s.x.z()});
    });
    const Spring spring(6.0);
    auto& ellipse = out.table("orbit_spring.tsv", {"x", "y", "z"});
    for (int i = 0; i <= 200; ++i) {
        const State<Vector3> s = spring.exact(start, 2 * pi / 6 * i / 200);
        ellipse.row({s.x.x(), s.x.y(), s.x.z()});
    }
    const double coarse = momentum_error(rope, start, 1.0 / 64, 64L * 8);
    const double fine = momentum_error(rope, start, 1.0 / 4096, 4096L * 8);
    std::printf(
        "  tether: in %g s its angular momentum strays by %.1e\n"
        "  at 64 steps a second, by %.1e at 4096\n",
        seconds, coarse, fine);
    out.number("momentum_fine", fine, "", "drift of the angular momentum, 4096 steps per second: the reference", 2);
    out.number("orbit_seconds", seconds, "s", "how long the tethered mass is followed");
    // 64 times smaller steps make an error of order four 64⁴ = 1.7e7 times smaller, down to the
    // roundoff of 32768 steps: 32768 · 2ε at the very worst.
    out.check("momentum_kept", fine < std::max(coarse / 1e6, 32768 * 2 * 2.3e-16),
              "with small steps the angular momentum of the tethered mass stays as it is");
}

}  // namespace

void hard_problems(const Settings& settings, lab::Findings& out) {
    out.section("Harder problems");
    drag(settings, out);
    tether(out);
}
