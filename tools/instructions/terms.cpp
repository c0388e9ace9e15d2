// Takes a number of steps in a scene, or in several, one after the other: a program for a profiler to count.
// `terms drag with 1000` steps a scene that names its drag, `terms drag without 1000` the same
// scene without it, and `terms drag hand 1000` a loop written by hand that has never heard of it.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/rigid/body_scene.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rope.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

#include "count.hpp"

namespace {

using namespace timestep;
using V = Vector3<double>;

constexpr double omega = 10, zeta = 0.1, k = 0.25, g = 9.81, h = 0.001, mu = 0.5;

// One degree of freedom.
template <class... Parts>
[[gnu::noinline]] double point(const Scene<Parts...>& scene, double x, double v, long n) {
    return run(semi_implicit_euler, scene, State{0, x, v}, h, n).x;
}
[[gnu::noinline]] double legs_and_drag_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        const double speed = v < 0 ? -v : v;
        v += h * (-omega * omega * x - 2 * zeta * omega * v - k * speed * v);
        x += h * v;
    }
    return x;
}
[[gnu::noinline]] double fall_with_drag_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        const double speed = v < 0 ? -v : v;
        v += h * (-g - k * speed * v);
        x += h * v;
    }
    return x;
}
[[gnu::noinline]] double spring_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        v += h * (-omega * omega * x - g);
        x += h * v;
    }
    return x;
}
[[gnu::noinline]] double legs_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        v += h * (-omega * omega * x - 2 * zeta * omega * v - g);
        x += h * v;
    }
    return x;
}

// A body.
struct Ball {
    UniformInertia<double> inertia;
    double mass, radius;
};
struct Crate {
    PrincipalInertia<double> inertia;
};

// All by value, here and in the loops written by hand: what stands elsewhere might change under
// their feet, and would be read anew in every step.
double seen(const BodyState<double>& m) {
    return m.x.sum() + m.v.sum() + m.turning.omega.sum() + m.turning.q.coeffs().sum();
}

template <class Body, class... Terms>
[[gnu::noinline]] double fly(BodyScene<Terms...> scene, Body body, BodyState<double> m, long n) {
    for (long i = 0; i < n; ++i) scene.step(body, m, h);
    return seen(m);
}
[[gnu::noinline]] double fly_by_hand(double gravity, BodyState<double> m, long n) {
    for (long i = 0; i < n; ++i) {
        m.v.z() -= h * gravity;
        m.turning.t += h;
        m.x += h * m.v;
        m.turning.q = rotated(m.turning.q, m.turning.omega, h);
    }
    return seen(m);
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
    return seen(m);
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

// The three ways to step one scene.
template <class With, class Without, class Hand>
double one_of(const std::string& way, const With& with, const Without& without, const Hand& hand) {
    if (way == "with") return with();
    if (way == "without") return without();
    if (way == "hand") return hand();
    std::fprintf(stderr, "terms: %s: with, without or hand\n", way.c_str());
    std::exit(2);
}

void take(const std::string& term, const std::string& way, long n) {
    const double one = unknown_one;

    const Spring spring(omega);
    const DampedSpring legs(omega, zeta);
    const Projectile gravity(-g);
    const Drag drag(k);
    const auto points = [&](const auto& with, const auto& without, const auto& hand) {
        return one_of(
            way, [&] { return point(with, one, 0, n); }, [&] { return point(without, one, 0, n); },
            [&] { return hand(one, 0, n); });
    };
    const Ball ball{sphere(one, 0.1 * one), one, 0.1 * one};
    const Crate crate{box(one, 1.0, 2.0, 3.0)};
    const BodyState<double> start{
        {0, Quaternion<double>(one, 2, 3, 4).normalized(), V(one, 2, 3)}, V(0, 0, 0.1 * one), V(3, one, 0)};
    const Weight weight(g * one);
    const Ground ground(mu * one);
    const Gyroscopic torque(passive_gyroscopic);
    const auto bodies = [&](const auto& body, const auto& with, const auto& without, const auto& hand) {
        return one_of(
            way, [&] { return fly(with, body, start, n); }, [&] { return fly(without, body, start, n); }, hand);
    };
    const auto fly_hand = [&] { return fly_by_hand(g * one, start, n); };

    double end = 0;
    if (term == "gravity")
        end = points(Scene(legs, gravity, drag), Scene(legs, drag), legs_and_drag_by_hand);
    else if (term == "spring")
        end = points(Scene(spring, gravity, drag), Scene(gravity, drag), fall_with_drag_by_hand);
    else if (term == "damper")
        end = points(Scene(legs, gravity), Scene(spring, gravity), spring_by_hand);
    else if (term == "drag")
        end = points(Scene(legs, gravity, drag), Scene(legs, gravity), legs_by_hand);
    else if (term == "gyroscopic_box")
        end = bodies(crate, BodyScene(weight, torque), BodyScene(weight), fly_hand);
    else if (term == "gyroscopic_ball")
        end = bodies(ball, BodyScene(weight, torque), BodyScene(weight), fly_hand);
    else if (term == "contact")
        end = bodies(ball, BodyScene(weight, ground), BodyScene(weight), fly_hand);
    else if (term == "rolling")
        end = bodies(ball, BodyScene(weight, ground, RollingResistance(0.01 * one)), BodyScene(weight, ground),
                     [&] { return slide_by_hand(g * one, mu * one, ball, start, n); });
    else if (term == "iterations")
        end = one_of(
            way, [&] { return rope(V(one, 2, 3), 8, n); }, [&] { return rope(V(one, 2, 3), 0, n); },
            [&] { return points_by_hand(V(one, 2, 3), n); });
    else
        std::exit((std::fprintf(stderr, "terms: %s: no such term\n", term.c_str()), 2));
    kept = end;
}

}  // namespace

int main(int argc, char** argv) {
    const auto one = [](char** words, long n) { take(words[0], words[1], n); };
    if (!count_all(argc, argv, 2, one))
        return std::fputs("terms: usage: terms TERM with|without|hand COUNT ...\n", stderr), 2;
}
