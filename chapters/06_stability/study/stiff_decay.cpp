// A decay much faster than the step, and swings much faster than the step: what is left of them?

#include <algorithm>
#include <cstdio>
#include <vector>

#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/velocity_verlet.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/stability.hpp>
#include <timestep/stability_function.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

constexpr double eps = 2.2e-16;
constexpr double step = 1e-3, lambda = -1e6;  // s, 1/s: hλ = −1000

template <class Method>
std::vector<double> decay(const Method& method, lab::Findings& out) {
    auto& table = out.table("stiff_" + lab::id(method.name) + ".tsv", {"n", "y", "size"});
    std::vector<double> y;
    run(method, Decay(lambda), FirstOrder<double>{0, 1.0}, step, 10, [&](const auto& state) {
        table.row({double(y.size()), state.y, std::fabs(state.y)});
        y.push_back(state.y);
    });
    std::printf("  %-20s after 1 step %9.2g, after 2 %9.2g, after 10 %9.2g\n", method.name, y[1], y[2], y[10]);
    return y;
}

void decays(lab::Findings& out) {
    std::printf("  y' = %g y, steps of %g s; the exact y is zero after one of them\n", lambda, step);
    const double z = step * lambda;
    out.number("stiff_z", z, "", "h lambda of the stiff decay", 4);
    out.number("stiff_lambda", lambda, "1/s", "the rate of the stiff decay", 4);
    const auto explicit_y = decay(explicit_euler, out), rk4 = decay(runge_kutta_4, out);
    const auto ringing = decay(implicit_midpoint, out), implicit_y = decay(implicit_euler, out);
    const auto bdf2_y = decay(bdf2, out);
    out.number("stiff_10_implicit_midpoint", ringing[10], "", "a stiff decay after ten steps");

    const auto factor = [&](const auto& method) { return stability_function(method, z).real(); };
    // Each of n steps rounds by a few ε of its largest term, which is R itself within a factor
    // near 1.
    const auto follows = [&](const auto& y, double r) {
        bool all = true;
        for (std::size_t n = 1; n < y.size(); ++n)
            all = all && std::fabs(y[n] / std::pow(r, double(n)) - 1) < 64 * eps * n;
        return all;
    };
    out.check("stiff_explicit",
              follows(explicit_y, factor(explicit_euler)) && follows(rk4, factor(runge_kutta_4)) &&
                  std::fabs(explicit_y[10]) > 1e29 && rk4[10] > std::fabs(explicit_y[10]),
              "explicit Euler blows a stiff decay up, and RK4 faster");
    bool alternates = std::fabs(ringing[10]) > 0.9;
    for (std::size_t n = 1; n < ringing.size(); ++n) alternates = alternates && ringing[n] * ringing[n - 1] < 0;
    out.check("stiff_rings", alternates,
              "implicit midpoint rings: it changes its sign with each step and hardly shrinks");
    out.check("stiff_dies", implicit_y[1] > 0 && implicit_y[1] < 0.001 && follows(implicit_y, factor(implicit_euler)),
              "implicit Euler lets a stiff decay die in one step");
    // On the left |R| is largest on the imaginary axis (maximum principle): the R of the first two
    // has no pole there. That of BDF2 jumps along z < −½, but it is the larger of two roots, whose
    // size is continuous and bows to the principle as each root's does (it is subharmonic).
    bool a_stable = true;
    for (double y = 1e-6; y < 1e8; y *= 1.1)
        for (const Complex r : {stability_function(implicit_euler, {0, y}),
                                stability_function(implicit_midpoint, {0, y}), stability_function(bdf2, {0, y})})
            a_stable = a_stable && std::abs(r) <= 1 + 8 * eps;
    out.check("a_stable", a_stable,
              "implicit Euler, implicit midpoint and BDF2 never grow where the exact motion decays");
    out.check("l_stable",
              std::abs(stability_function(implicit_euler, -1e12)) < 1e-6 &&
                  std::abs(stability_function(bdf2, -1e12)) < 1e-6 &&
                  std::abs(stability_function(implicit_midpoint, -1e12)) > 0.999999,
              "R tends to zero for implicit Euler and BDF2, and to -1 for implicit midpoint");
    out.check("stiff_bdf2", std::fabs(bdf2_y[1] + 0.996) < 0.001 && std::fabs(bdf2_y[2]) < 0.01,
              "BDF2, which starts with a step of implicit midpoint, rings once and is down in the "
              "second step");
}

// What a step multiplies the size of an undamped swing by.
template <class Method>
double factor(const Method& method, double wh) {
    if constexpr (HasStabilityFunction<Method>)
        return std::abs(stability_function(method, {0, wh}));
    else
        return spectral_radius(step_matrix(method, Spring(1.0), wh));
}

// The same, measured: the size brought back to 1 after each step. A swing that keeps its size ends
// anywhere on its ellipse, and what it adds is shared by all steps.
template <class Method>
double measured(const Method& method, double wh) {
    const Spring spring(1.0);
    const int fade = 200, count = 3000;
    State<double> before{0, 1.0, 0.0}, state = before;
    if constexpr (TwoStepMethod<Method, Spring<double>, State<double>>) state = method.start(spring, before, wh);
    double log_growth = 0;
    for (int i = 0; i < fade + count; ++i) {
        State<double> next;
        if constexpr (TwoStepMethod<Method, Spring<double>, State<double>>)
            next = method.step(spring, before, state, wh);
        else
            next = method.step(spring, state, wh);
        const double size = std::hypot(next.x, next.v);
        before = {0, state.x / size, state.v / size};
        state = {0, next.x / size, next.v / size};
        if (i >= fade) log_growth += std::log(size);
    }
    return std::exp(log_growth / count);
}

template <class Method>
double swing(const Method& method, lab::Findings& out) {
    const std::string id = lab::id(method.name);
    auto& line = out.table("swing_" + id + ".tsv", {"wh", "factor"});
    auto& marks = out.table("swing_measured_" + id + ".tsv", {"wh", "factor"});
    double worst = 0;
    for (int i = -200; i <= 300; ++i) {
        const double wh = std::pow(10, i / 100.0), predicted = factor(method, wh);
        if (predicted < 20) line.row({wh, predicted});
        if (i % 20 != 0 || predicted > 20) continue;
        const double found = measured(method, wh);
        marks.row({wh, found});
        worst = std::max(worst, std::fabs(std::log(found / predicted)));
    }
    return worst;
}

void swings(lab::Findings& out) {
    // Semi-implicit Euler's ellipse is √((2 + ωh)/(2 − ωh)) times as long as wide: 3 at the mark
    // nearest below 2, which stands at the ends of the count. The others' are rounder; the smaller
    // of BDF2's two motions, 0.94 times the larger a step for the longest ones here, has faded.
    const double worst =
        std::max({swing(implicit_midpoint, out), swing(implicit_euler, out), swing(bdf2, out),
                  swing(runge_kutta_4, out), swing(semi_implicit_euler, out), swing(velocity_verlet, out)});
    const double bound = std::log(3.0) / 3000;
    out.check("swings", worst < bound,
              "the growth of oscillations is the one predicted, for every method of the picture");

    double off = 0;
    bool kept = true, damped = true;
    for (int i = -200; i <= 600; ++i) {
        const double wh = std::pow(10, i / 100.0);
        off = std::max(off, std::fabs(factor(implicit_midpoint, wh) - 1));
        kept = kept && (wh > 1.999 || factor(semi_implicit_euler, wh) <= 1 + 8 * eps);
        damped = damped && factor(implicit_euler, wh) < 1 && factor(bdf2, wh) < 1;
    }
    const auto stable = [](double wh) { return factor(runge_kutta_4, wh) <= 1 + 1e-12; };
    const double limit = largest_stable_step(stable, 10.0);
    std::printf("  implicit midpoint keeps every oscillation within %.1e; RK4 up to omega h = %.6f\n", off, limit);
    out.number("rk4_swing_limit", limit, "", "largest omega h at which RK4 does not grow on an oscillation", 4);
    out.number("rk4_frame_limit", 60 * limit, "rad/s", "the omega of that at 60 Hz", 3);
    out.number("semi_frame_limit", 60 * 2, "rad/s", "the omega of omega h = 2 at 60 Hz");
    out.check("rk4_swing_limit", std::fabs(limit - std::sqrt(8.0)) < 1e-9, "RK4 is stable up to omega h = sqrt 8");
    out.check("p_stable", off < 8 * eps, "implicit midpoint keeps the size of an oscillation for every omega h");
    out.check("not_p_stable", kept && damped,
              "implicit Euler and BDF2 damp every oscillation; semi-implicit Euler keeps it up to "
              "omega h = 2");
    // Keeping the size is not keeping the time: by what angle does a step turn?
    const double fast = 100, turn = std::arg(stability_function(implicit_midpoint, {0, fast}));
    out.number("fast_swing", fast, "rad", "what a fast oscillation turns by in a step");
    out.number("fast_swing_midpoint", turn, "rad", "what implicit midpoint makes of that");
    out.check("fast_swing_is_slow", turn > 0 && turn < fast / 30,
              "implicit midpoint turns a fast oscillation by less than half a turn a step");
}

}  // namespace

void stiff_decay(const Settings&, lab::Findings& out) {
    out.section("Stiff decays and fast oscillations");
    decays(out);
    swings(out);
}
