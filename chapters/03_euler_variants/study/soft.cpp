// A spring in a solver's language: a soft constraint, made from ω and ζ.

#include <cmath>
#include <complex>
#include <cstdio>

#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/stability.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

// The solver knows a velocity and how far the constraint is off, and no force.
/// [soft]
struct SoftConstraint {
    double omega, zeta;

    double correct(double x, double v, double h) const {
        const double b = 2 * zeta + h * omega;
        const double all = h * omega * b;
        const double rate = omega / b;         // how fast x goes back
        const double share = all / (1 + all);  // from 0 to 1
        return v - share * (v + rate * x);
    }
};
/// [soft]

// As a method: the corrected velocity moves the position.
struct Solver {
    State<double> step(const SoftConstraint& soft, const State<double>& s, double h) const {
        const double v2 = soft.correct(s.x, s.v, h);
        return {s.t + h, s.x + h * v2, v2};
    }
};

// Today's solvers and yesterday's: a share of the error and of the impulse, typed in by hand. What
// spring is it at a step of h? Its acceleration is −k x − c v at the step's end, and one step tells
// k and c.
struct Typed {
    double rate, share, h;  // made for this h
    bool ode;               // its γ is CFM over the step
    State<double> step(const SoftConstraint&, const State<double>& s, double step) const {
        const double gamma = (1 / share - 1) * (ode ? h / step : 1);          // for a mass of one
        const double v2 = s.v - (s.v + rate * h / step * s.x) / (1 + gamma);  // β = rate h stays as it was typed
        return {s.t + step, s.x + step * v2, v2};
    }
};

// Angular frequency and damping of the motion that comes out, by the step's complex eigenvalue.
struct Felt {
    double omega, zeta;
};
template <class Method, class Model>
Felt felt(const Method& method, const Model& model, double h) {
    const std::complex<double> rate = std::log(eigenvalues(step_matrix(method, model, h)).first) / h;
    return {std::abs(rate), -rate.real() / std::abs(rate)};
}

// Three soft constraints pull one mass in a plane, one after another. Each alone would bring it to
// rest.
void several_at_one_mass(lab::Findings& out) {
    const double degrees[] = {20, 45, 0}, h = 1.0 / 60;
    const SoftConstraint soft[] = {{300, 0.1}, {30, 20}, {300, 0.1}};
    double x = 1, y = 0, vx = 0, vy = 0, alone = 0;
    for (const SoftConstraint& one : soft) alone = std::max(alone, spectral_radius(step_matrix(Solver{}, one, h)));
    for (int step = 0; step < 60; ++step) {
        for (int i = 0; i < 3; ++i) {
            const double c = std::cos(degrees[i] * pi / 180), s = std::sin(degrees[i] * pi / 180), v = c * vx + s * vy;
            const double change = soft[i].correct(c * x + s * y, v, h) - v;
            vx += c * change, vy += s * change;
        }
        x += h * vx, y += h * vy;
    }
    const double away = std::hypot(x, y);
    std::printf(
        "  three at one mass, one after another: from 1 m to %.3g m in 1 s; the largest factor of "
        "one alone: %.3f\n",
        away, alone);
    out.number("soft_three_away", away / 1000, "km", "how far a mass flies from 1 m in 1 s", 2);
    out.check("soft_three_blow_up", away > 1000 && alone < 1,
              "three soft constraints at one mass, each of which alone shrinks, one after another "
              "take it from 1 m to over 1 km "
              "in 1 s");
}

}  // namespace

void soft_constraints(const Settings&, lab::Findings& out) {
    out.section("A soft constraint");
    // The solver's two lines are implicit Euler on a damped spring: a step of each, rounded some
    // ten times.
    double worst = 0, largest = 0;
    for (const double zeta : {0.0, 0.1, 1.0, 10.0})
        for (double wh = 1e-3; wh < 2e3; wh *= 10) {
            const auto soft = step_matrix(Solver{}, SoftConstraint{1, zeta}, wh);
            const auto euler = step_matrix(implicit_euler, DampedSpring(1.0, zeta), wh);
            for (const auto& [a, b] : {std::pair(soft.xx, euler.xx), std::pair(soft.vv, euler.vv),
                                       std::pair(soft.vx * wh, euler.vx * wh), std::pair(soft.xv / wh, euler.xv / wh)})
                worst = std::max(worst, std::fabs(a - b));
            largest = std::max(largest, spectral_radius(soft));
        }
    std::printf(
        "  against implicit Euler: %.1e; the largest factor a step, omega h from 0.001 to 1000: "
        "%.9f\n",
        worst, largest);
    out.check("soft_is_implicit", worst < 20 * 2.3e-16,
              "a soft constraint's step is implicit Euler's on the damped spring, to roundoff");
    out.check("soft_never_grows", largest < 1,
              "no soft constraint grows, with omega h from 0.001 to 1000 and zeta from 0 to 10");

    // What the picture shows: a step's factor against ωh, lightly damped.
    const double zeta = 0.1;
    auto& lines = out.table("soft.tsv", {"wh", "exact", "spring", "soft"});
    auto& points = out.table("soft_points.tsv", {"wh", "soft"});
    double blows_up = 0;
    for (int i = 0; i <= 120; ++i) {
        const double wh = 0.05 * std::pow(1000.0, i / 120.0);
        const double spring = spectral_radius(step_matrix(semi_implicit_euler, DampedSpring(1.0, zeta), wh));
        const double soft = spectral_radius(step_matrix(Solver{}, SoftConstraint{1, zeta}, wh));
        lines.row({wh, std::exp(-zeta * wh), std::fmin(spring, 3), soft});
        if (blows_up == 0 && spring > 1) blows_up = wh;
        if (i % 10 != 0) continue;
        // Stepped: x and v turn and shrink; the determinant of two runs is the factor squared,
        // every step.
        const SoftConstraint model{1, zeta};
        State<double> a{0, 1, 0}, b{0, 0, 1};
        for (int n = 0; n < 4; ++n) a = Solver{}.step(model, a, wh), b = Solver{}.step(model, b, wh);
        points.row({wh, std::pow(a.x * b.v - a.v * b.x, 1.0 / 8)});
    }
    out.number("soft_zeta", zeta, "", "damping ratio in the picture");
    out.check("soft_where_springs_fail", blows_up > 1.7 && blows_up < 2.0,
              "the same spring as a force, by semi-implicit Euler, grows a little below omega h = 2");

    // The price: 5 Hz with little damping, at 60 Hz.
    const double hz = 5, omega = 2 * pi * hz, h = 1.0 / 60;
    const Felt designed = felt(Solver{}, SoftConstraint{omega, zeta}, h);
    const Felt often = felt(Solver{}, SoftConstraint{omega, zeta}, h / 4);
    std::printf(
        "  %g Hz and zeta %g, at 60 Hz, feel like %.3g Hz and zeta %.3g; at 240 Hz like zeta "
        "%.3g\n",
        hz, zeta, designed.omega / 2 / pi, designed.zeta, often.zeta);
    out.number("soft_hz", hz, "Hz", "a designer's spring");
    out.number("soft_felt_zeta", designed.zeta, "", "the damping ratio that it has at 60 Hz", 2);
    out.number("soft_felt_often", often.zeta, "", "and at 240 Hz", 2);
    const auto swings = [&](const Felt& f) { return f.omega * std::sqrt(1 - f.zeta * f.zeta) / (2 * pi); };
    out.number("soft_felt_swings", swings(designed), "", "how often it swings in a second at 60 Hz", 2);
    out.number("soft_often_swings", swings(often), "", "and at 240 Hz", 2);
    out.check("soft_adds_damping", designed.zeta > 2 * zeta && often.zeta < designed.zeta,
              "at 60 Hz a soft constraint of 5 Hz has over twice the damping asked for, at 240 Hz "
              "less of it");

    // Numbers typed in for 60 Hz, at 30 Hz: k = rate·share/(1 − share)/h and so on; the step tells.
    const double b = 2 * zeta + h * omega, share = h * omega * b / (1 + h * omega * b);
    const auto stiffness = [&](const Typed& typed,
                               double step) {  // v₂ = (v₁ − h k x₁)/(1 + h c + h² k)
        const auto m = step_matrix(typed, SoftConstraint{omega, zeta}, step);
        return -m.vx / m.vv / step;  // the entries' quotient
    };
    const Typed typed{omega / b, share, h, false}, ode{omega / b, share, h, true};
    const double softer = stiffness(typed, 2 * h) / stiffness(typed, h),
                 by_ode = stiffness(ode, 2 * h) / stiffness(ode, h);
    out.number("typed_softer", 1 / softer, "", "how much softer beta and gamma typed in at 60 Hz are at 30 Hz", 3);
    out.number("typed_softer_ode", 1 / by_ode, "", "how much softer ODE's ERP and CFM are", 3);
    out.check("typed_depends_on_the_rate", std::fabs(softer - 0.25) < 1e-12,
              "typed in as numbers, beta and gamma are a quarter of the stiffness at half the rate");
    out.check("typed_in_ode", std::fabs(by_ode - 0.5) < 1e-12,
              "typed in as ODE's ERP and CFM, which ODE divides by the step, they are half of the "
              "stiffness at half the rate");

    several_at_one_mass(out);
}
