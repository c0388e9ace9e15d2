// The same spring, stepped by three Eulers, in the phase portrait; and implicit Euler run
// backwards.

#include <cstdio>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

// What a step multiplied the amplitude by, on the average over the run, and between what it stayed.
struct Portrait {
    double growth, least = 1, most = 1;
};

template <class Method>
Portrait portrait(const Method& method, const Settings& settings, lab::Findings& out) {
    const std::string id = lab::id(Method::name);
    const Spring spring(settings.omega);
    const State start{0, 1.0, 0.0};  // pulled out by one metre and let go
    auto& table = out.table(id + ".tsv", {"t", "x", "v_over_omega"});
    const auto row = [&](const auto& s) { table.row({s.t, s.x, s.v / settings.omega}); };
    const State end = run(method, spring, start, settings.step, settings.steps, row);
    // As far as double reaches: what is smaller loses digits, what is larger is soon no number.
    double reached = 1;
    long steps = -1;  // the start is looked at, too
    bool in_range = true;
    Portrait result{};
    run(method, spring, start, settings.step, settings.steps, [&](const auto& s) {
        const double size = amplitude(s, settings.omega);
        result.least = std::min(result.least, size);
        result.most = std::max(result.most, size);
        in_range = in_range && size > 1e-290 && size < 1e150;
        if (in_range) reached = size, ++steps;
    });
    result.growth = std::pow(reached, 1.0 / static_cast<double>(std::max(steps, 1L)));
    if (settings.wants(Method::name) && !is_finite(end))
        std::printf("  %-20s has left the range of numbers, after %ld steps or more\n", Method::name, steps);
    else if (settings.wants(Method::name))
        std::printf("  %-20s ends at x = %10.4g m, v = %10.4g m/s, amplitude %.4g m\n", Method::name, end.x, end.v,
                    amplitude(end, settings.omega));
    out.number(id + "_amplitude", amplitude(end, settings.omega), "m", "amplitude at the end of the run");
    out.number(id + "_growth", result.growth, "", "amplitude times this a step", 5);
    out.number(id + "_per_second", std::pow(result.growth, 1 / settings.step), "", "amplitude times this a second");
    return result;
}

// Explicit Euler over one second with a step, its half, its quarter, its eighth: closer each time,
// and each time twice the work.
void smaller_steps(const Settings& settings, lab::Findings& out) {
    const Spring spring(settings.omega);
    const State start{0, 1.0, 0.0};
    const double seconds = 4 * pi / settings.omega;  // two swings
    std::printf("  explicit Euler, error after two periods:\n   ");
    double before = 0;
    for (const long divisor : {1, 2, 4, 8}) {
        const long steps = divisor * std::max(1L, std::lround(seconds / settings.step));
        auto& table = out.table("smaller_" + std::to_string(divisor) + ".tsv", {"t", "x"});
        const State end = run(explicit_euler, spring, start, seconds / steps, steps, [&](const auto& s) {
            table.row({s.t, s.x});
        });
        const State exact = spring.exact(start, seconds);
        const double error = amplitude({0, end.x - exact.x, end.v - exact.v}, settings.omega);
        std::printf(" %.3g m (%ld steps)", error, steps);
        out.number("smaller_steps_" + std::to_string(divisor), double(steps), "", "steps in two periods");
        out.number("smaller_error_" + std::to_string(divisor), error, "m", "error after two periods");
        if (divisor > 1)
            out.check("smaller_is_better_" + std::to_string(divisor), error < before,
                      "explicit Euler's error falls as the step is halved");
        before = error;
    }
    std::printf("\n");
    auto& exact = out.table("smaller_exact.tsv", {"t", "x"});
    for (int i = 0; i <= 400; ++i) {
        const double t = seconds * i / 400;
        exact.row({t, spring.exact(start, t).x});
    }
}

// Implicit Euler from the start, then explicit Euler with a negative step from where that ended.
void backwards(const Settings& settings, lab::Findings& out) {
    const Spring spring(settings.omega);
    const long steps = std::min(settings.steps, 40L);
    auto& there = out.table("there.tsv", {"t", "x", "v_over_omega"});
    auto& back = out.table("back.tsv", {"t", "x", "v_over_omega"});
    State state{0, 1.0, 0.0};
    for (long i = 0; i < steps; ++i) {
        there.row({state.t, state.x, state.v / settings.omega});
        state = implicit_euler.step(spring, state, settings.step);
    }
    there.row({state.t, state.x, state.v / settings.omega});
    for (long i = 0; i < steps; ++i) {
        back.row({state.t, state.x, state.v / settings.omega});
        state = explicit_euler.step(spring, state, -settings.step);
    }
    back.row({state.t, state.x, state.v / settings.omega});
    const double miss = std::hypot(state.x - 1, state.v / settings.omega);
    std::printf("  %ld implicit steps, then as many explicit ones with -h, miss the start by %.1e m\n", steps, miss);
    out.number("backwards_steps", double(steps), "", "steps there, and back");
    out.number("backwards_miss", miss, "m", "distance from the start after going there and back", 2);
    // A step there and back rounds by a few ε of the amplitude, and explicit Euler carries each
    // error on, larger, to the end: by no more than (1 + ω²h²)^(steps/2).
    const double carried = std::pow(1 + settings.wh() * settings.wh(), steps / 2.0);
    out.check("backwards", miss < 20 * steps * 2.2e-16 * carried,
              "implicit Euler is explicit Euler run backwards, to roundoff");
}

}  // namespace

void portraits(const Settings& settings, lab::Findings& out) {
    out.section("Three Eulers on one spring");
    std::printf("  omega = %g rad/s, h = %.5g s (omega h = %.4g), %ld steps\n", settings.omega, settings.step,
                settings.wh(), settings.steps);
    const double explicit_growth = portrait(explicit_euler, settings, out).growth;
    const double implicit_growth = portrait(implicit_euler, settings, out).growth;
    const Portrait semi = portrait(semi_implicit_euler, settings, out);

    auto& circle = out.table("exact.tsv", {"x", "v_over_omega"});
    for (int i = 0; i <= 360; ++i) circle.row({std::cos(i * pi / 180), -std::sin(i * pi / 180)});

    const double factor = std::sqrt(1 + settings.wh() * settings.wh());
    out.number("omega", settings.omega, "rad/s", "angular frequency of the spring");
    out.number("rate", 1 / settings.step, "Hz", "steps a second");
    out.number("wh", settings.wh(), "", "angular frequency times step");
    out.number("steps", double(settings.steps), "", "steps in the portraits");
    out.number("seconds", settings.steps * settings.step, "s", "length of the portraits");
    // The root of the last amplitude takes the roundoff of the run down to that of one step.
    const double roundoff = 20 * 2.2e-16;
    out.check("explicit_grows", std::fabs(explicit_growth / factor - 1) < roundoff,
              "explicit Euler multiplies the amplitude by sqrt(1 + (omega h)^2) a step");
    out.check("implicit_shrinks", std::fabs(implicit_growth * factor - 1) < roundoff,
              "implicit Euler divides the amplitude by sqrt(1 + (omega h)^2) a step");
    // The kept energy, here ½ω², is between 1 − ωh/2 and 1 + ωh/2 times the true one, and that is
    // ½ω² times the square of the amplitude.
    out.check("semi_implicit_stays",
              semi.most < std::sqrt(1 / (1 - settings.wh() / 2)) * (1 + settings.steps * roundoff) &&
                  semi.least > std::sqrt(1 / (1 + settings.wh() / 2)) * (1 - settings.steps * roundoff),
              "semi-implicit Euler's amplitude stays between 1/sqrt(1 + omega h/2) and 1/sqrt(1 - omega "
              "h/2)");
    smaller_steps(settings, out);
    backwards(settings, out);
}
