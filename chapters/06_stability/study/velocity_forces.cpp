// Forces that depend on the velocity and are no dampers: what becomes of the energy under
// semi-implicit Euler?

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <Eigen/Core>

#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

using V = Eigen::Vector2d;

// Two equal masses on two equal rods, by the angles of the rods to the vertical. Lengths are in
// pixels and times in frames, as in many a first program.
struct DoublePendulum {
    double rod = 200, gravity = 1;  // px, px/frame²

    // Lagrange's equations, solved for the two angular accelerations.
    V acceleration(const V& angle, const V& rate) const {
        const double c = std::cos(angle[0] - angle[1]), s = std::sin(angle[0] - angle[1]);
        const double first = -s * rate[1] * rate[1] - 2 * gravity / rod * std::sin(angle[0]);
        const double second = s * rate[0] * rate[0] - gravity / rod * std::sin(angle[1]);
        return V(first - c * second, 2 * second - c * first) / (2 - c * c);
    }
    // Over the mass; zero where it hangs at rest.
    double energy(const State<V>& s) const {
        const double cross = s.v[0] * s.v[1] * std::cos(s.x[0] - s.x[1]);
        return rod * rod * (s.v[0] * s.v[0] + s.v[1] * s.v[1] / 2 + cross) +
               gravity * rod * (3 - 2 * std::cos(s.x[0]) - std::cos(s.x[1]));
    }
    // Of its two small oscillations the fast one has ω² = (2 + √2) g/l.
    double fastest() const { return std::sqrt((2 + std::sqrt(2)) * gravity / rod); }
};

constexpr long frames = 36'000;  // ten minutes at 60 Hz

struct Energy {
    double least = 1, most = 1, end = 1;  // over the first
    bool drifted() const { return !(least > 0.5 && most < 2); }
};

// Let go at rest, the upper rod at `angle`; `visit(frame, energy)` once per frame.
template <class Method, class Visit>
Energy swing(const Method& method, double angle, int steps_per_frame, const Visit& visit) {
    const DoublePendulum pendulum;
    const State<V> start{0, {angle, 0}, {0, 0}};
    const double first = pendulum.energy(start);
    Energy seen;
    long n = 0;
    run(method, pendulum, start, 1.0 / steps_per_frame, frames * steps_per_frame, [&](const State<V>& s) {
        const double now = pendulum.energy(s) / first;
        seen.least = std::min(seen.least, now), seen.most = std::max(seen.most, now), seen.end = now;
        if (n++ % steps_per_frame == 0) visit(n / steps_per_frame, now);
    });
    return seen;
}

void pendulums(lab::Findings& out) {
    auto& table = out.table("drift.tsv", {"minutes", "semi-implicit Euler", "four steps per frame", "Runge-Kutta 4"});
    std::vector<double> one, four, kutta;
    const auto into = [](std::vector<double>& all) { return [&all](long, double energy) { all.push_back(energy); }; };
    const Energy semi = swing(semi_implicit_euler, 1, 1, into(one)),
                 shorter = swing(semi_implicit_euler, 1, 4, into(four)),
                 exact = swing(runge_kutta_4, 1, 1, into(kutta));
    for (std::size_t i = 0; i < kutta.size(); i += 60) table.row({double(i) / 3600, one[i], four[i], kutta[i]});

    // It is chaotic: of other starts close by, too.
    bool all_drift = true, all_stay = true;
    for (int i = -5; i <= 5; ++i) {
        const auto nothing = [](long, double) {};
        const double angle = 1 + 0.002 * i;
        for (const int steps : {1, 4})
            all_drift = all_drift && swing(semi_implicit_euler, angle, steps, nothing).drifted();
        const Energy e = swing(runge_kutta_4, angle, 1, nothing);
        all_stay = all_stay && e.least > 0.98 && e.most < 1.001;
    }
    const double turn = DoublePendulum{}.fastest();
    std::printf(
        "  a double pendulum in angles, omega h = %.3f, 36,000 frames; energy over the first, "
        "least, most, at the end:\n",
        turn);
    const auto print = [](const char* name, const Energy& e) {
        std::printf("  %-42s %7.3f %7.3f %7.4f\n", name, e.least, e.most, e.end);
    };
    print("semi-implicit Euler", semi), print("semi-implicit Euler, four steps per frame", shorter),
        print("Runge-Kutta 4", exact);
    out.number("drift_turn", turn, "", "ωh of the double pendulum's fastest small oscillation, a step per frame", 3);
    out.number("drift_most", semi.most, "",
               "the most energy of the double pendulum under semi-implicit Euler, over the first", 2);
    out.number("drift_shorter_most", shorter.most, "", "the same with four steps per frame", 2);
    out.number("drift_kutta", 100 * (1 - exact.end), "%", "what Runge-Kutta 4 loses in the same time", 2);
    out.check("pendulum_drifts", all_drift && all_stay && semi.most > 2 && shorter.most > 2,
              "in ten minutes at 60 Hz, from eleven starts, the energy of the double pendulum gets "
              "above twice or below half the first under "
              "semi-implicit Euler, with one step per frame and with four, and under Runge-Kutta 4 "
              "stays within two percent");
}

// One pendulum, whose force depends on the position alone, with long steps and with short ones.
void one_pendulum(lab::Findings& out) {
    const double from = 2.5, long_turn = 1.1, short_turn = 0.5;
    const auto most = [&](double turn) {
        const Pendulum pendulum(1.0);
        const State<double> start{0, from, 0};
        double energy = 0;
        run(semi_implicit_euler, pendulum, start, turn, 100'000L,
            [&](const State<double>& s) { energy = std::max(energy, pendulum.energy(s) / pendulum.energy(start)); });
        return energy;
    };
    const double seen = most(long_turn), still = most(short_turn);
    std::printf(
        "  a pendulum let go at %.1f rad, most energy over the first in 100,000 steps: omega h = "
        "%.1f: %.4g, %.1f: %.4g\n",
        from, long_turn, seen, short_turn, still);
    out.number("pendulum_from", from, "rad", "where the pendulum is let go");
    out.number("pendulum_turn", long_turn, "", "its ωh, the long step");
    out.number("pendulum_most", seen, "", "its most energy in 100,000 long steps, over the first", 2);
    out.check("pendulum_needs_short_steps", seen > 10 && still < 1.5,
              "let go at 2.5 rad, a pendulum has more than ten times its energy within 100,000 "
              "steps of ωh = 1.1, and with ωh = 0.5 less than 1.5 "
              "times as much");
}

// A velocity that turns, as in a magnetic field or, apart from the other terms, in a frame that
// turns: a = Ω × v.
struct Turning {
    double rate;  // rad/s
    V acceleration(const V&, const V& v) const { return rate * V(-v.y(), v.x()); }
};

void turning(lab::Findings& out) {
    const double rate = 1, h = 1.0 / 60;
    const State<V> start{0, {0, 0}, {1, 0}};
    const double semi = run(semi_implicit_euler, Turning{rate}, start, h, 3600L).v.norm();
    const double kutta = run(runge_kutta_4, Turning{rate}, start, h, 3600L).v.norm();
    const double predicted = std::pow(1 + rate * rate * h * h, 1800);  // explicit Euler's, of the velocity
    std::printf("  a = Omega x v, 1 rad/s, 60 Hz: in a minute the speed x %.4g, Runge-Kutta 4 x %.9f\n", semi, kutta);
    out.number("turning_speed", semi, "", "what a minute of a = Ω × v multiplies the speed by, 1 rad/s at 60 Hz", 4);
    out.check("turning_grows", std::abs(semi / predicted - 1) < 1e-9 && semi > 1.6 && std::abs(kutta - 1) < 1e-6,
              "under semi-implicit Euler a step multiplies the speed by √(1 + Ω²h²), as under "
              "explicit Euler; under Runge-Kutta 4 the speed stays "
              "within a millionth in a minute");
}

}  // namespace

void velocity_forces(const Settings&, lab::Findings& out) {
    out.section("Forces that depend on the velocity");
    one_pendulum(out);
    pendulums(out);
    turning(out);
}
