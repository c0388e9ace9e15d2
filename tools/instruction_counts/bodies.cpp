// A body and a rope, with a term, without it, and by a loop written by hand that has never heard of it: "contact_with",
// "contact", "hand_contact".

#include <cmath>

#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/rigid/body_scene.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rope.hpp>

#include "cases.hpp"
#include "chapters/06_stability/study/mixed.hpp"

namespace {

using namespace timestep;
using V = Vector3<double>;

constexpr double g = 9.81, h = 0.001, mu = 0.5;

struct Ball {
    UniformInertia<double> inertia;
    double mass, radius;
};
struct Crate {
    PrincipalInertia<double> inertia;
};

// Everything is passed by value, here and in the loops written by hand: a value that lies elsewhere might change, and
// would be read again in every step.
double sum(const BodyState<double>& m) {
    return m.x.sum() + m.v.sum() + m.turning.omega.sum() + m.turning.q.coeffs().sum();
}

template <class Body, class... Terms>
[[gnu::noinline]] double fly(BodyScene<Terms...> scene, Body body, BodyState<double> m, long n) {
    for (long i = 0; i < n; ++i) scene.step(body, m, h);
    return sum(m);
}
[[gnu::noinline]] double fly_by_hand(double gravity, BodyState<double> m, long n) {
    for (long i = 0; i < n; ++i) {
        m.v.z() -= h * gravity;
        m.turning.t += h;
        m.x += h * m.v;
        m.turning.q = rotated(m.turning.q, m.turning.omega, h);
    }
    return sum(m);
}
[[gnu::noinline]] double slide_by_hand(double gravity, double mu, Ball ball, BodyState<double> m, long n) {
    const double r = ball.radius, I = ball.inertia.moment;
    V& v = m.v;
    V& spin = m.turning.omega;
    for (long i = 0; i < n; ++i) {
        m.turning.t += h;
        v.z() -= h * gravity;
        const double gap = m.x.z() - r;
        const double lift = -(gap > 0 ? gap : 0.0) / h - v.z();
        if (lift > 0) {
            v.z() += lift;
            const double u = v.x() - r * spin.y(), w = v.y() + r * spin.x();
            const double speed = std::sqrt(u * u + w * w);
            const double stop = speed / (1 / ball.mass + r * r * (1 / I));
            if (stop > 0) {
                const double limit = mu * (ball.mass * lift);
                const double share = -(stop < limit ? stop : limit) / speed;
                const double px = share * u, py = share * w;
                v.x() += px / ball.mass, v.y() += py / ball.mass;
                spin.x() += r * (1 / I) * py, spin.y() -= r * (1 / I) * px;
            }
        }
        m.x += h * v;
        m.turning.q = rotated(m.turning.q, spin, h);
    }
    return sum(m);
}

// A rope of sixty links.
[[gnu::noinline]] double rope(const V& along, int sweeps, long n) {
    Rope<V> rope(V(0, 0, 0), along, 60, 0.1, Projectile<V>(V(0, 0, -g)));
    for (long i = 0; i < n; ++i) rope.step(h, sweeps);
    return rope.points().back().x.sum();
}
[[gnu::noinline]] double points_by_hand(const V& along, long n) {
    const V gravity(0, 0, -g);
    std::vector<V> now(61), before(61);
    for (int i = 0; i <= 60; ++i) now[i] = before[i] = i * 0.1 * along.normalized();
    for (long step = 0; step < n; ++step)
        for (int i = 1; i <= 60; ++i) {
            const V next = 2 * now[i] - before[i] + h * h * gravity;
            before[i] = now[i];
            now[i] = next;
        }
    return now.back().sum();
}

template <class With, class Without, class Hand>
void add(std::vector<Case>& all, const std::string& term, const With& with, const Without& without, const Hand& hand) {
    all.push_back({term + "_with", 500, [=](long n) { kept = with(n); }});
    all.push_back({term, 500, [=](long n) { kept = without(n); }});
    all.push_back({"hand_" + term, 500, [=](long n) { kept = hand(n); }});
}

void add_bodies(std::vector<Case>& all) {
    const double one = unknown_one;
    const Ball ball{sphere(one, 0.1 * one), one, 0.1 * one};
    const Crate crate{box(one, 1.0, 2.0, 3.0)};
    const BodyState<double> start{
        {0, Quaternion<double>(one, 2, 3, 4).normalized(), V(one, 2, 3)}, V(0, 0, 0.1 * one), V(3, one, 0)};
    const Weight weight(g * one);
    const Ground ground(mu * one);
    const Gyroscopic torque(passive_gyroscopic);
    const auto of = [=](const auto& body, const auto&... terms) {
        return [=](long n) { return fly(BodyScene(terms...), body, start, n); };
    };
    const auto fly_hand = [=](long n) { return fly_by_hand(g * one, start, n); };
    const auto slide_hand = [=](long n) { return slide_by_hand(g * one, mu * one, ball, start, n); };
    add(all, "gyroscopic_box", of(crate, weight, torque), of(crate, weight), fly_hand);
    add(all, "gyroscopic_ball", of(ball, weight, torque), of(ball, weight), fly_hand);
    add(all, "contact", of(ball, weight, ground), of(ball, weight), fly_hand);
    add(all, "rolling", of(ball, weight, ground, RollingResistance(0.01 * one)), of(ball, weight, ground), slide_hand);
}

void add_rope(std::vector<Case>& all) {
    const V along(double(unknown_one), 2, 3);
    add(
        all, "iterations", [=](long n) { return rope(along, 8, n); }, [=](long n) { return rope(along, 0, n); },
        [=](long n) { return points_by_hand(along, n); });
}

// A crowd of 64 bodies of one kind, kept in one of the ways of mixed.hpp: what a body's step takes.
const BodyScene crowd_scene{Weight(9.81), Gyroscopic(passive_gyroscopic)};

template <class Crowd, class Scene>
[[gnu::noinline]] void step(Crowd& crowd, Scene scene, long n) {
    for (long i = 0; i < n; ++i) crowd.step(scene, 0.001);
}

template <class Crowd, class Scene>
void add_crowd(std::vector<Case>& all, const std::string& way, const Scene& scene) {
    const auto add_kind = [&](const std::string& kind, auto add_body) {
        all.push_back({way + "_" + kind, 6400, [=](long count) {
                           Crowd crowd;
                           for (int i = 0; i < 64; ++i) add_body(crowd, i);
                           step(crowd, scene, count / 64);
                       }});
    };
    add_kind("ball", [](Crowd& crowd, int i) { mixed::add_ball(crowd, i); });
    add_kind("capsule", [](Crowd& crowd, int i) { mixed::add_capsule(crowd, i); });
    add_kind("box", [](Crowd& crowd, int i) { mixed::add_box(crowd, i); });
}

}  // namespace

std::vector<Case> bodies_and_rope() {
    std::vector<Case> all;
    add_bodies(all);
    add_rope(all);
    return all;
}

std::vector<Case> crowds() {
    std::vector<Case> all;
    add_crowd<mixed::Sorted>(all, "sorted", crowd_scene);
    add_crowd<mixed::Sorted>(all, "no_torque", BodyScene{Weight(9.81)});
    add_crowd<mixed::Variants>(all, "variant", crowd_scene);
    add_crowd<mixed::Virtuals<decltype(crowd_scene)>>(all, "virtual", crowd_scene);
    add_crowd<mixed::Alike>(all, "alike", crowd_scene);
    return all;
}
