// The longest stable step of every method on a damped spring: predicted, and found by running it.

#include <algorithm>
#include <cstdio>
#include <numbers>
#include <vector>

#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/stability.hpp>
#include <timestep/stability_function.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

constexpr double pi = std::numbers::pi;

// R(z) of the spring's two decays, z = ωh (−ζ ± √(ζ² − 1)), is one at most.
template <class Method>
double predicted(const Method& method, double zeta) {
    const Complex root = std::sqrt(Complex(zeta * zeta - 1));
    return largest_stable_step(
        [&](double wh) {
            return std::abs(stability_function(method, wh * (-zeta + root))) <= 1 &&
                   std::abs(stability_function(method, wh * (-zeta - root))) <= 1;
        },
        100.0);
}
// No R here. With s = ωh, from the step's trace and determinant: an eigenvalue is −1 where
// 1 + trace + determinant = 4 ∓ 4ζs − s² = 0, with − for damping at the old velocity, + at the new.
double predicted(const SemiImplicitEuler&, double zeta) { return 2 / (std::hypot(1, zeta) + zeta); }
double predicted(const SemiImplicitEulerNewDamping&, double zeta) { return 2 * (std::hypot(1, zeta) + zeta); }
// Determinant 1 − 2ζs + s²/2: a swing grows from s = 4ζ on. 1 + trace + determinant = 4 − 4ζs: a
// state flips from s = 1/ζ on.
double predicted(const ConstantAcceleration&, double zeta) { return std::min(4 * zeta, 1 / zeta); }

/// [grows]
// Longer after twice the steps? Enough steps for 200 swings.
template <class Method>
bool grows(const Method& method, double zeta, double wh) {
    const DampedSpring model(1.0, zeta);
    const int steps = int(std::clamp(200 * 2 * pi / wh, 4000.0, 200000.0));
    State state{0, 1.0, 0.3};
    double halfway = 0;
    for (int i = 1; i <= 2 * steps; ++i) {
        state = method.step(model, state, wh);
        const double size = std::hypot(state.x, state.v);
        if (!(size < 1e100)) return true;
        if (size < 1e-100) return false;
        if (i == steps) halfway = size;
    }
    return std::hypot(state.x, state.v) > halfway;
}
/// [grows]

template <class Grows>
double found_by_bisection(const Grows& grows) {
    double stable = std::log(1e-3), unstable = std::log(1e2);
    for (int i = 0; i < 34; ++i) {
        const double middle = (stable + unstable) / 2;
        (grows(std::exp(middle)) ? unstable : stable) = middle;
    }
    return std::exp(stable);
}

// The condition number of A's eigenvectors, the columns (a.xv, λ − a.xx) of length one. The squares
// of the two singular values are 1 ± c with the cosine c between the columns, and so the larger
// over the smaller is (1 + c) over their product, the determinant.
double condition(const StepMatrix<double>& a) {
    const auto [first, second] = eigenvalues(a);
    const Complex below1 = first - a.xx, below2 = second - a.xx;
    const double sizes = std::sqrt(a.xv * a.xv + std::norm(below1)) * std::sqrt(a.xv * a.xv + std::norm(below2));
    const double cosine = std::abs(a.xv * a.xv + std::conj(below1) * below2) / sizes;
    const double determinant = std::abs(a.xv * (below2 - below1)) / sizes;
    return (1 + cosine) / determinant;
}

// How far off may such a run be? In n steps a state is multiplied by Aⁿ, whose size lies between
// |λ|ⁿ/κ and κ|λ|ⁿ with the condition number κ of A's eigenvectors. So it tells |λ| from 1 where
// n ln|λ| > ln κ, and ln|λ| rises with ln(ωh) at a rate that we take from A a little beyond.
template <class Method>
double bound(const Method& method, double zeta, double wh) {
    const DampedSpring model(1.0, zeta);
    const double beyond = 1e-3;
    const double rate = std::log(spectral_radius(step_matrix(method, model, wh * (1 + beyond)))) / beyond;
    const double steps = std::clamp(200 * 2 * pi / wh, 4000.0, 200000.0);
    const double bisected = std::log(1e5) / std::pow(2.0, 34);
    return std::log(condition(step_matrix(method, model, wh))) / (steps * rate) + 2 * bisected;
}

struct Worst {
    double off = 0, over_bound = 0;
    int points = 0;
};

template <class Method>
void edge(const Method& method, Worst& worst, lab::Findings& out) {
    const std::string id = lab::id(method.name);
    auto& line = out.table("edge_" + id + ".tsv", {"zeta", "wh"});
    auto& marks = out.table("edge_measured_" + id + ".tsv", {"zeta", "wh"});
    for (int i = -200; i <= 100; i += 2) {
        const double zeta = std::pow(10, i / 100.0);
        line.row({zeta, predicted(method, zeta)});
    }
    for (int i = -190; i <= 90; i += 20) {  // not at ζ = 1, where a spring's two decays are one
        const double zeta = std::pow(10, i / 100.0), expected = predicted(method, zeta);
        const double found = found_by_bisection([&](double wh) { return grows(method, zeta, wh); });
        marks.row({zeta, found});
        const double off = std::fabs(std::log(found / expected));
        worst.off = std::max(worst.off, off);
        worst.over_bound = std::max(worst.over_bound, off / bound(method, zeta, expected));
        ++worst.points;
    }
    std::printf("  %-32s %9.4f %9.4f %9.4f %9.4f\n", method.name, predicted(method, 0.01), predicted(method, 0.1),
                predicted(method, 1), predicted(method, 10));
    out.number("edge_hard_" + id, predicted(method, 10), "", "longest stable omega h at zeta = 10");
}

// Without damping. At ωh = 2 + δ Verlet grows by e^(2√δ) a step, to 10⁶ in 20,000 steps where δ is
// above 1.2e-7; at 2 the size rises by less than 3 a step, to less than 10⁵.
template <class Method>
double undamped(const Method& method) {
    return found_by_bisection([&](double wh) {
        const State<double> end = run(method, Spring(1.0), State{0, 1.0, 0.3}, wh, 20000);
        return !(std::hypot(end.x, end.v) < 1e6);
    });
}

// No edge: never ten times the start's size and more, from ωh = 0.01 to a million.
template <class Method>
bool always_bounded(const Method& method) {
    for (const double zeta : {0.0, 0.01, 0.1, 0.5, 0.9, 1.1, 3.0, 10.0})
        for (double wh = 0.01; wh < 2e6; wh *= 2.5) {
            bool small = true;
            run(method, DampedSpring(1.0, zeta), State{0, 1.0, 0.3}, wh, 1000,
                [&](const auto& s) { small = small && std::hypot(s.x, s.v) < 10; });
            if (!small) return false;
        }
    return true;
}

}  // namespace

void boundary(const Settings&, lab::Findings& out) {
    out.section("The longest stable step of every method");
    std::printf("  %-32s %9s %9s %9s %9s\n", "omega h, for the damping ratio", "0.01", "0.1", "1", "10");
    Worst worst;
    edge(explicit_euler, worst, out), edge(constant_acceleration, worst, out), edge(midpoint, worst, out);
    edge(heun, worst, out), edge(runge_kutta_4, worst, out);
    edge(semi_implicit_euler, worst, out), edge(semi_implicit_euler_new_damping, worst, out);
    std::printf("  %d limits found by running: within %.1e of the formulas\n", worst.points, worst.off);
    out.number("edge_points", worst.points, "", "limits found by running");
    out.number("edge_off", 100 * worst.off, "%", "limits found by running against formulas, worst", 1);
    out.check("edges", worst.over_bound < 1, "the limits found by running are those of the formulas");

    auto& marks = out.table("edge_undamped.tsv", {"method", "wh"});
    double off = 0;
    const auto mark = [&](const auto& method) {
        const double found = undamped(method);
        marks.row({std::string(method.name), found});
        off = std::max(off, std::fabs(found - 2));
    };
    mark(verlet), mark(velocity_verlet), mark(leapfrog), mark(semi_implicit_euler);
    mark(semi_implicit_euler_new_damping);
    std::printf("  without damping Verlet's kind and semi-implicit Euler: 2 within %.1e\n", off);
    out.check("edge_undamped", off < 3e-7,
              "without damping the three Verlets stop where semi-implicit Euler stops, at 2");

    const bool unlimited = always_bounded(implicit_euler) && always_bounded(implicit_midpoint) && always_bounded(bdf2);
    out.check("edge_none", unlimited,
              "implicit Euler, implicit midpoint and BDF2 have no limit: bounded up to omega h of "
              "a million");

    bool alike = true;
    for (const double hard : {predicted(explicit_euler, 10), predicted(constant_acceleration, 10),
                              predicted(midpoint, 10), predicted(semi_implicit_euler, 10)})
        alike = alike && std::fabs(hard / 0.1 - 1) < 0.01;
    out.check("edge_hard_alike",
              alike && predicted(runge_kutta_4, 10) < 0.15 && predicted(semi_implicit_euler_new_damping, 10) > 40,
              "damped hard, the explicit methods all stop near omega h = 1/zeta, and new damping "
              "reaches far beyond 4 zeta");
}
