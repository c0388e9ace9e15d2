// The curves of chapter 1: lines, a parabola, exponentials, a sine, and the chords that turn into
// tangents. Every slope drawn as a dot comes from a difference formula.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include <timestep/differences.hpp>

#include "derivatives.hpp"
#include "functions.hpp"

using namespace timestep;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// N01: chords through x and x + h, for smaller and smaller h, and the tangent.
template <class Function>
void secants(const Function& f, double x, lab::Findings& out) {
    auto& table = out.table("secants.tsv", {"x", "f", "chord_1", "chord_2", "chord_3", "tangent"});
    const auto chord = [&](double h, double at) { return f(x) + forward_difference(f, x, h) * (at - x); };
    for (int i = -40; i <= 60; ++i) {
        const double at = x + i / 50.0;
        table.row({at, f(at), chord(1, at), chord(0.5, at), chord(0.25, at), f(x) + f.derivative(1, x) * (at - x)});
    }
    auto& ends = out.table("secant_ends.tsv", {"x", "f"});
    for (const double h : {0.0, 0.25, 0.5, 1.0}) ends.row({x + h, f(x + h)});
}

// N02: a line's slope is the same everywhere, and a difference finds it but for rounding.
void line(lab::Findings& out) {
    const auto rising = [](auto x) { return x / 2 + 1; };
    const auto level = [](auto) { return 2.5; };
    auto& table = out.table("line.tsv", {"x", "rising", "level"});
    for (double x = -1; x <= 4; x += 0.5) table.row({x, rising(x), level(x)});

    auto& ends = out.table("line_ends.tsv", {"x", "y"});
    for (const double x : {1.0, 3.0}) ends.row({x, rising(x)});

    double worst = 0;  // in units of ε |f|/h
    bool level_is_zero = true;
    for (int i = 0; i < 1000; ++i) {
        const double x = -1 + i / 200.0, h = std::exp2(-i % 40) / 3;
        const double error = std::fabs(forward_difference(rising, x, h) - 0.5);
        worst = std::max(worst, error * h / (epsilon * std::fabs(rising(x))));
        level_is_zero = level_is_zero && forward_difference(level, x, h) == 0;
    }
    out.check("line_exact", worst <= 4, "on a line the error is at most 4 eps |f|/h, that is, rounding");
    out.check("level_zero", level_is_zero, "on a horizontal line the difference is exactly zero");
}

// N03: the tangent turns as x goes on; the slopes of a parabola lie on a line.
void parabola(lab::Findings& out) {
    const auto f = [](double x) { return x * x; };
    auto& table = out.table("parabola.tsv", {"x", "f", "slope", "left", "middle", "right"});
    const auto tangent = [&](double at, double x) { return f(at) + 2 * at * (x - at); };
    for (int i = -20; i <= 20; ++i) {
        const double x = i / 20.0;
        table.row({x, f(x), 2 * x, tangent(-0.75, x), tangent(0.25, x), tangent(0.6, x)});
    }
    auto& dots = out.table("parabola_dots.tsv", {"x", "f", "slope"});
    constexpr double h = 0.25;
    double error = 0;
    for (const double x : {-0.75, 0.25, 0.6}) {
        const double slope = central_difference(f, x, h);
        dots.row({x, f(x), slope});
        error = std::max(error, std::fabs(slope - 2 * x));
    }
    // |f| ≤ 1 within reach of the step: rounding is at most 4 ε/h.
    out.number("parabola_step", h, "", "the step of the parabola's central differences");
    out.check("parabola_exact", error <= 4 * epsilon / h,
              "on a parabola the central difference errs by rounding alone, even with h = 0.25");
}

// N04, N05: an exponential's slope is an exponential, a sine's is a cosine.
constexpr double compare_step = 1e-3;

template <class F, class Slope>
void compare(const char* name, const F& f, const Slope& slope, double from, double to, lab::Findings& out) {
    auto& table = out.table(std::string(name) + ".tsv", {"x", "f", "slope"});
    for (int i = 0; i <= 200; ++i) {
        const double x = from + (to - from) * i / 200;
        table.row({x, f(x), slope(x)});
    }
    auto& dots = out.table(std::string(name) + "_dots.tsv", {"x", "slope"});
    double worst = 0;
    for (int i = 0; i <= 12; ++i) {
        const double x = from + (to - from) * i / 12;
        const double found = central_difference(f, x, compare_step);
        dots.row({x, found});
        worst = std::max(worst, std::fabs(found - slope(x)));
    }
    out.number(std::string(name) + "_error", worst, "", "largest error of its central differences", 2);
}

// N07, N08: the three chords around one point of a sine.
void chords(lab::Findings& out) {
    const Sine f;
    constexpr double t1 = 0.9, h = 0.7;
    auto& curve = out.table("chords.tsv", {"t", "x", "tangent", "forward", "backward", "central"});
    const auto through = [&](double slope, double t) { return f(t1) + slope * (t - t1); };
    for (int i = -110; i <= 110; ++i) {
        const double t = t1 + i / 100.0;
        const double chord = f(t1 - h) + central_difference(f, t1, h) * (t - (t1 - h));
        curve.row({t, f(t), through(std::cos(t1), t), through(forward_difference(f, t1, h), t),
                   through(backward_difference(f, t1, h), t), chord});
    }
    auto& dots = out.table("chord_dots.tsv", {"t", "x"});
    for (const double t : {t1 - h, t1, t1 + h}) dots.row({t, f(t)});
}

template <class Function>
void slopes(const Function& f, const Settings& settings, lab::Findings& out) {
    const double x = settings.at, h = settings.step, exact = f.derivative(1, x);
    std::printf("exactly %.12g\n", exact);
    const auto print = [&](const auto& formula) {
        const double slope = formula(f, x, h), error = slope - exact;
        std::printf("  %-11s %.12g, off by %.2g\n", formula.name, slope, error);
        std::string name = formula.name;
        std::replace(name.begin(), name.end(), '-', '_');
        out.number(name + "_error", std::fabs(error), "", "error of that slope at the given x and h", 2);
    };
    print(forward_difference);
    print(backward_difference);
    print(central_difference);
    print(five_point_difference);
    out.check("central_is_better",
              std::fabs(central_difference(f, x, h) - exact) < std::fabs(forward_difference(f, x, h) - exact),
              "the central difference errs less than the forward one, for as many values");
    secants(f, x, out);
}

}  // namespace

void curves(const Settings& settings, lab::Findings& out) {
    char title[80];
    std::snprintf(title, sizeof title, "The slope of %s at x = %g, with h = %g", settings.function.c_str(), settings.at,
                  settings.step);
    out.section(title);
    out.number("step", settings.step, "", "the step h of the four slopes");
    out.number("at", settings.at, "", "the x of the four slopes");
    with_function(settings.function, [&](const auto& f) { slopes(f, settings, out); });

    line(out);
    parabola(out);
    constexpr double a = 1.5;
    out.number("exponent", a, "", "the a of the exponentials drawn");
    out.number("compare_step", compare_step, "", "the step of their and the sine's differences");
    compare(
        "growth", [](double x) { return std::exp(a * x); }, [](double x) { return a * std::exp(a * x); }, -2, 1, out);
    compare(
        "decay", [](double x) { return std::exp(-a * x); }, [](double x) { return -a * std::exp(-a * x); }, -0.5, 2.5,
        out);
    compare(
        "sine", [](double x) { return std::sin(x); }, [](double x) { return std::cos(x); }, 0, 2 * std::numbers::pi,
        out);
    chords(out);
}
