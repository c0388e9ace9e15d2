// Three ways to spoil a slope: no step left, a clock that has run for hours, and a kink.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <timestep/differences.hpp>

#include "derivatives.hpp"
#include "functions.hpp"

using namespace timestep;

namespace {

void no_step_left(lab::Findings& out) {
    const double h = 1e-17;
    const double slope = forward_difference(Exponential{}, 1.0, h);
    std::printf("exp at 1 with h = %g: slope %g\n", h, slope);
    out.number("lost_step", h, "", "a step too small for a double at 1");
    out.number("lost_slope", slope, "", "the slope of exp at 1 with that step");
    out.check("lost", slope == 0 && step_taken(1.0, h) == 0, "1 + h is 1 again, and the slope comes out as zero");
}

// A platform moves as x = sin t m; this is the largest error of its velocity over ten seconds.
struct ClockErrors {
    double over_h = 0, over_step = 0, in_double = 0;
};

ClockErrors after(double hours, double rate) {
    const float h = static_cast<float>(1 / rate);
    /// [clock]
    const auto x = [](auto t) { return std::sin(t); };
    const auto over_h = [&](float t) { return forward_difference(x, t, h); };
    const auto over_step = [&](float t) {
        const float taken = step_taken(t, h);
        return forward_difference(x, t, taken);
    };
    /// [clock]
    ClockErrors largest;
    const auto note = [](double& error, double found, double t) {
        error = std::max(error, std::fabs(found - std::cos(t)));
    };
    for (int frame = 0; frame < 10 * rate; ++frame) {
        const double now = 3600 * hours + frame / rate;
        const float t = static_cast<float>(now);
        note(largest.over_h, over_h(t), t);
        note(largest.over_step, over_step(t), t);
        note(largest.in_double, forward_difference(x, now, 1 / rate), now);
    }
    return largest;
}

void long_game(double rate, lab::Findings& out) {
    std::printf("a platform moves as x = sin t, at up to 1 m/s; t is a float,\n");
    std::printf("%g frames a second; largest error of its forward difference, in m/s\n", rate);
    std::printf("       played   divided by h   by the step taken   t a double\n");
    // Half the gap between neighbouring floats outgrows h at a power of two.
    const float h = static_cast<float>(1 / rate);
    float stop = 1;
    while (step_taken(stop, h) > 0) stop *= 2;
    auto& table = out.table("clock.tsv", {"hours", "over_h", "over_step", "in_double"});
    for (double hours = 0.05; 3600 * hours + 10 < stop; hours *= 1.02) {
        const ClockErrors errors = after(hours, rate);
        table.row({hours, errors.over_h, errors.over_step, errors.in_double});
    }
    out.table("clock_stop.tsv", {"hours"}).row({stop / 3600.0});
    for (const double hours : {0.1, 1.0, 10.0}) {
        const ClockErrors errors = after(hours, rate);
        std::printf("  %9g h   %12.2g   %17.2g   %10.2g\n", hours, errors.over_h, errors.over_step, errors.in_double);
    }
    std::printf("from %.4g h on t + h = t: the clock stands still\n", stop / 3600.0);

    constexpr double early_hours = 0.1, late_hours = 10;
    const double early = after(early_hours, rate).over_h;
    const ClockErrors late = after(late_hours, rate);
    out.number("clock_early_hours", early_hours, "hours", "early in the game");
    out.number("clock_late_hours", late_hours, "hours", "late in the game");
    out.number("clock_early", early, "m/s", "error after 0.1 hours, divided by h", 2);
    out.number("clock_late", late.over_h, "m/s", "error after 10 hours, divided by h", 2);
    out.number("clock_late_step", late.over_step, "m/s", "error after 10 hours, over the step taken", 2);
    out.number("clock_spacing", 1000 * (std::nextafter(36000.0f, 1e9f) - 36000.0f), "ms",
               "from one float to the next after 10 hours", 2);
    out.number("clock_stops", stop / 3600.0, "hours", "from here on t + h = t in float", 4);
    out.check("clock", late.over_h > 5 * early && late.over_step < 2 * early,
              "after 10 hours the slope over h errs over 5 times what it did after 0.1 hours; over "
              "the step "
              "taken it errs less than twice that");
}

// A ball comes down at 5 m/s, bounces at t = 0 and leaves at 4 m/s: it has no velocity there.
void kink(lab::Findings& out) {
    const auto height = [](double t) { return t < 0 ? -5 * t : 4 * t; };
    const double h = 1.0 / 64;
    const double ahead = forward_difference(height, 0.0, h);
    const double behind = backward_difference(height, 0.0, h);
    const double central = central_difference(height, 0.0, h);
    std::printf("a bounce: forward %g m/s, backward %g m/s, central %g m/s, whatever h is\n", ahead, behind, central);
    out.number("kink_forward", ahead, "m/s", "forward difference at a bounce");
    out.number("kink_backward", behind, "m/s", "backward difference at a bounce");
    out.number("kink_central", central, "m/s", "central difference at a bounce");
    bool same = true;
    for (int k = 0; k <= 40; ++k) same = same && central_difference(height, 0.0, std::ldexp(1.0, -k)) == central;
    out.check("kink", same, "at the bounce the central difference is the same for h = 1, 1/2, 1/4 and on");
}

}  // namespace

void mistakes(const Settings& settings, lab::Findings& out) {
    out.section("Break it");
    no_step_left(out);
    kink(out);
    long_game(settings.rate, out);
}
