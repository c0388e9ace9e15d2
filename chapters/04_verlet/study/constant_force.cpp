// The constant-force method: exact for projectiles, growing on every undamped spring.

#include <algorithm>
#include <cstdio>

#include <timestep/methods/constant_acceleration.hpp>
#include <timestep/methods/velocity_verlet.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/run.hpp>
#include <timestep/stability.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

// What a step multiplies by in the long run, by stepping: normed in between, so that nothing
// overflows. The first steps turn the state into the direction that grows fastest, where there is
// one.
const int measured_steps = 20000;
double measured_growth(double wh) {
    const Spring spring(1.0);
    State s{0, 1.0, 0.3};
    double log_growth = 0;
    const int skip = 2000;
    for (int n = 0; n < skip + measured_steps; ++n) {
        s = constant_acceleration.step(spring, s, wh);
        const double size = std::hypot(s.x, s.v);
        if (n >= skip) log_growth += std::log(size);
        s = {0, s.x / size, s.v / size};
    }
    return std::exp(log_growth / measured_steps);
}

// The larger root of λ² − (2 − w²/2) λ + (1 + w²/2) = 0, w = ωh.
double formula(double wh) {
    const double half_trace = 1 - wh * wh / 4, det = 1 + wh * wh / 2;
    if (wh <= 4) return std::sqrt(det);
    return std::fabs(half_trace) + std::sqrt(half_trace * half_trace - det);
}

}  // namespace

void constant_force(const Settings& settings, lab::Findings& out) {
    out.section("A constant force over the step");
    // A ball, up and down again, with steps from a millisecond to longer than the flight.
    const Projectile gravity(-9.81);
    const State thrown{0, 2.0, 14.0};
    double worst = 0;
    bool within = true;
    for (const long steps : {1L, 2L, 7L, 100L, 2800L}) {
        const State end = run(constant_acceleration, gravity, thrown, 2.8 / steps, steps);
        const State exact = gravity.exact(thrown, 2.8);
        worst = std::max(worst, distance(end, exact));
        // A step rounds x, below 12 m, and v, 14 m/s or less, by an ε of them or two; what v lost
        // moves x for the rest of the 2.8 s. And 2.8/steps is rounded itself.
        within = within && distance(end, exact) < (steps + 2.0) * 2 * eps * (12 + 14 * 2.8);
    }
    std::printf(
        "  a ball, 2.8 s in 1 to 2800 steps: the constant-acceleration step is off by %.1e at "
        "most\n",
        worst);
    out.number("ball_worst", worst, "m", "the constant-acceleration step's error on a projectile, any step", 2);
    out.check("ball_exact", within, "the constant-force method is exact on a projectile but for rounding");

    const Spring spring(1.0);
    auto& lines = out.table("constant_acceleration_line.tsv", {"wh", "constant_acceleration", "root"});
    for (int i = 0; i <= 300; ++i) {
        const double wh = 0.02 * i;
        lines.row({wh, formula(wh), std::sqrt(1 + wh * wh / 2)});
    }
    auto& points = out.table("constant_acceleration_points.tsv", {"wh", "growth"});
    double off = 0, beyond = 0;
    bool as_it_says = true;
    for (const double wh : {0.01, 0.1, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.5, 5.0, 5.5}) {
        const double growth = measured_growth(wh);
        points.row({wh, growth});
        if (wh < 4) {
            off = std::max(off, std::fabs(growth / formula(wh) - 1));
            // Every step multiplies x² + v² − (ωh/2) x v, whose axes are as √(1 + ωh/4) to √(1 −
            // ωh/4), by the same: the amplitude's logarithm wanders by no more than that of their
            // ratio. And a step's rounds by an ε or two.
            const double ripple = std::log((1 + wh / 4) / (1 - wh / 4)) / 2;
            as_it_says = as_it_says &&
                         std::fabs(std::log(growth) - std::log1p(wh * wh / 2) / 2) < ripple / measured_steps + 4 * eps;
        }
        if (wh == 5.0) beyond = growth;
        const double radius = spectral_radius(step_matrix(constant_acceleration, spring, wh));
        as_it_says = as_it_says && std::fabs(radius / formula(wh) - 1) < 1e-12;
    }
    const double wh = settings.wh(), a_second = std::pow(formula(wh), 1 / settings.step);
    std::printf(
        "  an undamped spring grows by sqrt(1 + (omega h)^2/2) a step: %.5f at omega h = %.3g,\n"
        "  %.3g in a second; measured within %.1e up to omega h = 4\n",
        formula(wh), wh, a_second, off);
    out.number("newton_growth", formula(wh), "", "the constant-acceleration step's growth a step", 5);
    out.number("newton_per_second", a_second, "", "the constant-acceleration step's growth a second");
    out.number("newton_at_5", beyond, "", "the constant-acceleration step's growth a step at omega h = 5");
    out.number("newton_at_5_root", std::sqrt(1 + 12.5), "", "what the root would say at omega h = 5");
    out.check("newton_grows", as_it_says,
              "the constant-acceleration step multiplies an undamped spring's amplitude by sqrt(1 "
              "+ (omega h)^2/2) a step, "
              "up to omega h = 4");
    out.check("newton_beyond", beyond > 1.05 * std::sqrt(1 + 12.5),
              "beyond omega h = 4 the constant-acceleration step grows faster than by the root");
}
