// Both demos of the talk, a projectile and a spring, with every method met so far.

#include <algorithm>
#include <cstdio>
#include <vector>

#include <Eigen/Core>

#include <timestep/methods.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;
using Eigen::Vector2d;

namespace {

template <class Visit>
void for_each_demo_method(const Visit& visit) {
    visit(explicit_euler), visit(implicit_euler), visit(semi_implicit_euler);
    for_each_verlet_method(visit);
}

const double step = 0.1;  // s
const long steps = 24;    // a ball's flight, and a swing and a half of the spring
const double omega = 4;   // rad/s

}  // namespace

void demos(const Settings&, lab::Findings& out) {
    out.section("Projectile and spring, every method");
    const Projectile gravity(Vector2d(0, -9.81));
    const State<Vector2d> thrown{0, {0, 0}, {8, 11.7}};
    const Spring spring(omega);
    const State let_go{0, 1.0, 0.0};
    out.number("demo_seconds", steps * step, "s", "length of the ball's flight", 3);
    out.number("demo_step", step, "s", "step of both demos");
    out.number("demo_wh", omega * step, "", "angular frequency times step in the demo");

    auto& summary =
        out.table("demos.tsv", {"method", "ball: off at the end (m)", "spring: amplitude after 1000 steps"});
    std::printf("  %-20s %22s %24s\n", "", "ball: off at the end", "spring: after 1000 steps");
    double exact_on_ball = 0, off_on_ball = 1e9, least = 1e9, most = 0;
    for_each_demo_method([&](const auto& method) {
        const std::string id = lab::id(method.name);
        auto& ball = out.table("ball_" + id + ".tsv", {"t", "x", "y"});
        const State end = run(method, gravity, thrown, step, steps, [&](const auto& s) {
            ball.row({s.t, s.x(0), s.x(1)});
        });
        const double off = (end.x - gravity.exact(thrown, steps * step).x).norm();
        auto& portrait = out.table("spring_" + id + ".tsv", {"t", "x", "v_over_omega"});
        run(method, spring, let_go, step, steps, [&](const auto& s) { portrait.row({s.t, s.x, s.v / omega}); });

        auto& long_run = out.table("amplitude_" + id + ".tsv", {"t", "amplitude"});
        const auto amplitude = [&](const auto& s) { return std::hypot(s.x, s.v / omega); };
        long n = 0;
        const State last = run(method, spring, let_go, step, 1000, [&](const auto& s) {
            if (n++ <= 150) long_run.row({s.t, amplitude(s)});
        });
        const double reached = amplitude(last);
        char off_text[24], reached_text[24];
        std::snprintf(off_text, sizeof off_text, "%.1e", off);
        std::snprintf(reached_text, sizeof reached_text, "%.3g", reached);
        std::printf("  %-20s %20s m %22s m\n", method.name, off_text, reached_text);
        summary.row({std::string(method.name), std::string(off_text), std::string(reached_text)});

        // With a constant force these four are pieces of the parabola itself; the Eulers miss it by
        // h g t/2.
        const bool parabola =
            id == "verlet" || id == "velocity_verlet" || id == "leapfrog" || id == "constant_acceleration";
        if (parabola)
            exact_on_ball = std::max(exact_on_ball, off);
        else
            off_on_ball = std::min(off_on_ball, off);
        if (method.order == 2 || id == "semi_implicit_euler")
            least = std::min(least, reached), most = std::max(most, reached);
        if (id == "constant_acceleration" || id == "explicit_euler" || id == "semi_implicit_euler") {
            out.number("ball_" + id, off, "m", "off at the end of the flight");
            out.number("spring_" + id, reached, "m", "amplitude after 1000 steps");
        }
    });
    auto& path = out.table("ball_exact.tsv", {"t", "x", "y"});
    auto& circle = out.table("circle.tsv", {"x", "v"});
    for (int i = 0; i <= 120; ++i) {
        const State s = gravity.exact(thrown, steps * step * i / 120);
        path.row({s.t, s.x(0), s.x(1)});
        circle.row({std::cos(i * pi / 60), -std::sin(i * pi / 60)});
    }
    out.number("ball_parabolas", exact_on_ball, "m", "worst of the four that fly parabolas", 2);
    // 24 steps, each rounding positions below 20 m and velocities that act for 2.4 s; see
    // constant_force.cpp.
    out.check("parabolas", exact_on_ball < steps * 4 * eps * (20 + 12 * 2.4) && off_on_ball > 1,
              "Verlet in all its forms and constant acceleration fly the parabola itself, and "
              "every Euler misses it");
    // Semi-implicit Euler keeps x² + (v/ω)² − ωh x (v/ω), here 1: on the ellipse's axes, x = ±v/ω,
    // the amplitude is 1/√(1 ∓ ωh/2). The others swing on an upright one within it.
    const double half = omega * step / 2;
    out.check("verlets_stay", least > 1 / std::sqrt(1 + half) && most < 1 / std::sqrt(1 - half),
              "semi-implicit Euler and Verlet in all its forms keep the oscillation");
}
