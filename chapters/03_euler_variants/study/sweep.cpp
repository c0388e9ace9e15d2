// Semi-implicit Euler pushed to its limit and past it.

#include <cstdio>

#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/run.hpp>
#include <timestep/stability.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

std::string label(double wh) {
    char text[16];
    std::snprintf(text, sizeof text, "%.2f", wh);
    return text;
}

// The steps that one full swing takes, from the times at which x rises through zero.
double steps_per_swing(double wh, long steps) {
    const Spring spring(1.0);
    double first = -1, last = -1;
    long swings = -1;
    State before{0, 1.0, 0.0};
    run(semi_implicit_euler, spring, before, wh, steps, [&](const auto& s) {
        if (before.x < 0 && s.x >= 0) {
            last = s.t - wh * s.x / (s.x - before.x);
            if (swings < 0) first = last;
            ++swings;
        }
        before = s;
    });
    return (last - first) / wh / swings;
}

// cos θ = 1 − (ωh)²/2 is half the trace of the step matrix; a swing is 2π/θ steps.
double predicted_steps_per_swing(double wh) { return 2 * pi / std::acos(1 - wh * wh / 2); }

void portraits_near_the_limit(lab::Findings& out) {
    const Spring spring(1.0);
    double worst = 0;
    std::printf("  %6s %22s %22s\n", "omega h", "period, exact (steps)", "measured");
    for (const double wh : {0.1, 0.5, 1.0, 1.5, 1.9, 1.99, 2.0, 2.01}) {
        auto& table = out.table("sweep_" + label(wh) + ".tsv", {"x", "v_over_omega"});
        // At the limit the state leaves along a line, past it along a curve, within a few steps.
        run(semi_implicit_euler, spring, State{0, 1.0, 0.0}, wh, wh < 2 ? 400 : 12, [&](const auto& s) {
            table.row({s.x, s.v});
        });
        if (wh >= 2) continue;
        const long steps = 100000;
        const double measured = steps_per_swing(wh, steps);
        std::printf("  %7.2f %22.4f %22.4f\n", wh, 2 * pi / wh, measured);
        worst = std::max(worst, std::fabs(measured / predicted_steps_per_swing(wh) - 1));
    }
    const auto after = [&](double wh, long steps) {
        return run(semi_implicit_euler, spring, State{0, 1.0, 0.0}, wh, steps);
    };
    const State sixth = after(1, 6);
    out.check("six_points", std::hypot(sixth.x - 1, sixth.v) < 1e-14, "at omega h = 1 the sixth state is the first");
    const double gained = after(2, 200).x - after(2, 100).x, again = after(2, 300).x - after(2, 200).x;
    out.check("linear_at_2", std::fabs(again / gained - 1) < 1e-12 && std::fabs(gained) > 100,
              "at omega h = 2 the oscillation grows by the same amount each step");
    // The straight line between two steps puts each crossing at most one step off: 2 in 100000.
    out.check("frequency", worst < 2e-5, "semi-implicit Euler swings with cos(theta) = 1 - (omega h)^2/2");
}

// One portrait a frame, ωh rising slowly.
void frames(lab::Findings& out) {
    const Spring spring(1.0);
    auto& table = out.table("sweep_frames.tsv", {"wh", "x", "v_over_omega"});
    for (int frame = 0; frame <= 80; ++frame) {
        const double wh = frame < 76 ? 0.1 + frame * 0.025 : 2.0 + (frame - 76) * 0.004;
        run(semi_implicit_euler, spring, State{0, 1.0, 0.0}, wh, wh < 2 ? 240 : 60, [&](const auto& s) {
            if (std::fabs(s.x) < 9 && std::fabs(s.v) < 9) table.row({wh, s.x, s.v});
        });
        table.gap();
        table.gap();
    }
}

void rule_of_thumb(lab::Findings& out) {
    auto& table = out.table("steps_per_period.tsv", {"steps", "period_error_percent"});
    for (const double n : {3.2, 3.5, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0})
        table.row({n, 100 * (steps_per_swing(2 * pi / n, 100000) / n - 1)});

    const auto radius = [](double steps) {
        return spectral_radius(step_matrix(semi_implicit_euler, Spring(1.0), 2 * pi / steps));
    };
    const double four = 100 * (steps_per_swing(2 * pi / 4, 100000) / 4 - 1);
    const double ten = 100 * (steps_per_swing(2 * pi / 10, 100000) / 10 - 1);
    std::printf("  4 steps a period: growth x %.6f a step, the period is off by %.1f %%\n", radius(4), four);
    std::printf("  3 steps a period: growth x %.3f a step\n", radius(3));
    out.number("period_error_4", std::fabs(four), "%", "period too short by, at 4 steps a period");
    out.number("period_error_10", std::fabs(ten), "%", "period too short by, at 10 steps a period", 2);
    out.number("growth_3", radius(3), "", "growth a step at 3 steps a period");
    out.check("four_steps", std::fabs(radius(4) - 1) < 1e-15 * 8 && radius(3) > 1,
              "4 steps a period are stable, 3 are not");
}

// An oscillation without a sine: the stepped spring is A cos(nθ + φ) itself, not near it.
void sine_without_sine(const Settings& settings, lab::Findings& out) {
    const double wh = settings.wh(), h = settings.step;
    const double theta = std::acos(1 - wh * wh / 2);
    const State start{0, 1.0, 0.0};
    const Spring spring(settings.omega);
    const double x1 = semi_implicit_euler.step(spring, start, h).x;
    // x₀ = A cos φ and x₁ = A cos(θ + φ) give A sin φ = (x₀ cos θ − x₁)/sin θ.
    const double a_sin = (start.x * std::cos(theta) - x1) / std::sin(theta);
    const double a = std::hypot(start.x, a_sin), phi = std::atan2(a_sin, start.x);

    auto& table = out.table("sine.tsv", {"n", "stepped", "cosine"});
    double worst = 0;
    long n = 0;
    const long steps = 1000000;
    run(semi_implicit_euler, spring, start, h, steps, [&](const auto& s) {
        const double cosine = a * std::cos(n * theta + phi);
        worst = std::max(worst, std::fabs(s.x - cosine));
        if (n <= 80) table.row({double(n), s.x, cosine});
        ++n;
    });
    std::printf("  %ld steps follow a cos(n theta + phi) within %.1e m\n", steps, worst);
    out.number("sine_worst", worst, "m", "stepped spring against a cosine, worst", 2);
    out.number("sine_steps", double(steps), "", "steps compared with a cosine");
    // θ is known to a few ε/sin θ, and each step adds a rounding of as much to the angle: n of
    // them.
    const double angle = 8 * 2.2e-16 / std::sin(theta) * steps;
    out.check("sine", wh < 2 && worst < a * angle, "the stepped spring is a sampled cosine");
}

}  // namespace

void sweep(const Settings& settings, lab::Findings& out) {
    out.section("Pushing the step");
    portraits_near_the_limit(out);
    frames(out);
    rule_of_thumb(out);
    sine_without_sine(settings, out);
}
