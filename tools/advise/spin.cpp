// Can one step raise the energy of my spinning body? What every way to treat the gyroscopic torque can do at a given
// step, in the worst direction.

#include <algorithm>
#include <cmath>

#include <timestep/gyroscopic.hpp>

#include "advise_body.hpp"
#include "method_on_spring.hpp"

namespace timestep {

// The direction in which a step gains most, or one that gains more than `enough`. Turning the body
// half round an axis changes two signs of ω and nothing else, so two octants are all there are: ω₁,
// ω₂ > 0 with either sign of ω₃. A net of directions, finer near the axes, where a gain begins as a
// small share of a small wobble; then, from the best of them, smaller and smaller moves.
Worst worst_direction(const std::function<double(const Vector3<double>&)>& gain_towards, double enough) {
    using V = Vector3<double>;
    Worst worst;
    const auto look = [&](const V& way) {
        const V direction = way.normalized();
        double gain = gain_towards(direction);
        if (std::isnan(gain)) gain = std::numeric_limits<double>::infinity();  // 0/0: no solution
        if (gain > worst.gain) worst = {gain, direction};
        return worst.gain > enough;
    };
    // Ratios of two components, from 1e-3 to 1e3.
    for (int i = -9; i <= 9; ++i)
        for (int j = -9; j <= 9; ++j)
            for (const double sign : {-1, 1})
                if (look(V(1, std::pow(10, i / 3.0), sign * std::pow(10, j / 3.0)))) return worst;
    // Round each axis, where the first gains are needles.
    for (int axis = 0; axis < 3; ++axis)
        for (double wobble = 0.1; wobble > 5e-4; wobble /= 1.15)
            for (int k = 0; k < 64; ++k) {
                V way = V::Unit(axis);
                way[(axis + 1) % 3] = wobble * std::cos(k * 0.09817477042468103);
                way[(axis + 2) % 3] = wobble * std::sin(k * 0.09817477042468103);
                if (look(way)) return worst;
            }
    double reach = 0.3;
    while (reach > 1e-4) {
        const Worst before = worst;
        const V across = before.direction.unitOrthogonal(), third = before.direction.cross(across);
        for (int k = 0; k < 8; ++k) {
            const double angle = k * 0.7853981633974483;
            if (look(before.direction + reach * (std::cos(angle) * across + std::sin(angle) * third))) return worst;
        }
        const double rise = worst.gain - before.gain;
        if (!(rise > 1e-15 && rise > 0.01 * (before.gain - 1))) reach /= 2;
    }
    return worst;
}

// The longest step of the talk's iteration with which no direction gains. With three different
// moments the first gains begin close to the intermediate axis, where h|ω| = √(I₁I₃)/(I₃ − I₁), I₁
// the least and I₃ the largest moment. That was found by search, not proved: over random bodies no
// direction gains a thousandth below it, and some direction does a thousandth above.
double longest_safe_step(const PrincipalInertia<double>& inertia, double spin) {
    const Vector3<double>& I = inertia.unit;
    const double least = I.minCoeff(), most = I.maxCoeff();
    return std::sqrt(least) * std::sqrt(most) / (most - least) / spin;
}

// From which step on its gain has no bound. The determinant of its equations is, in the order of
// the moments I₁ < I₂ < I₃ and with a₁, a₃ > 0 > a₂ the ratios of the body,
//     1 + u² + w² − v² − 2uvw,  u² = −a₂a₃h²ω₁², v² = a₁a₃h²ω₂², w² = −a₁a₂h²ω₃²,
// where u, v and w have the signs that make the last term what it is. As |2uw| ≤ u² + w² it is at
// least (1 − |v|)(1 + |v| + u² + w²), above zero for |v| < 1; at v = 1 it is (u − w)², zero at u =
// w.
double unbounded_step(const PrincipalInertia<double>& inertia, double spin) {
    const Vector3<double>& a = inertia.ratio;
    // Of the three products only a₁a₃ is above zero.
    return 1 / std::sqrt(std::max({a.x() * a.y(), a.y() * a.z(), a.z() * a.x()})) / spin;
}

bool no_torque(const PrincipalInertia<double>& inertia) { return (inertia.ratio.array() == 0).all(); }

namespace {

template <class Solver>
double energy_gain(const Solver& solver, const PrincipalInertia<double>& any_size, const Vector3<double>& omega,
                   double h) {
    const PrincipalInertia<double> inertia = any_size.scaled_to_one();
    if constexpr (requires { solver.step(inertia, omega, h); }) {  // in body coordinates, as it is
        const Vector3<double> next = solver.step(inertia, omega, h);
        return kinetic_energy(inertia, next) / kinetic_energy(inertia, omega);
    } else {
        const RigidState<double> before{0, Quaternion<double>::Identity(), omega};
        const RigidState<double> after = step_rotation(solver, inertia, before, h);
        return kinetic_energy(inertia, after) / kinetic_energy(inertia, before);
    }
}

SpinAdvice spin_advice(const char* method, double h, int work) {
    const double infinity = std::numeric_limits<double>::infinity();
    return {method, Verdict::stable, "", 1, Vector3<double>::Zero(), infinity, work / h};
}

template <class Solver>
void find_worst(SpinAdvice& advice, const Solver& solver, const PrincipalInertia<double>& inertia, double spin,
                double h) {
    const Worst worst = worst_direction([&](const Vector3<double>& direction) {
        return energy_gain(solver, inertia, Vector3<double>(direction), h * spin);  // |ω| may be any size
    });
    advice.worst_gain = std::max(worst.gain, 1.0);
    advice.worst_spin = spin * worst.direction;
    if (advice.verdict != Verdict::grows || worst.gain > 1 + more_than_roundoff) return;
    advice.verdict = Verdict::too_close_to_call;
    advice.reason += "; here less than 1e-12 of the energy, lost in roundoff";
}

// A solver that adds energy at every step where there is a torque.
template <class Solver>
SpinAdvice judge_adding(const Solver& solver, const PrincipalInertia<double>& inertia, double spin, double h,
                        const char* why) {
    SpinAdvice advice = spin_advice(solver.name, h, 1);
    if (no_torque(inertia)) return advice.reason = "equal moments: no gyroscopic torque", advice;
    advice.verdict = Verdict::grows;
    advice.longest_step = 0;
    advice.reason = why;
    find_worst(advice, solver, inertia, spin, h);
    return advice;
}

SpinAdvice judge_spin(const ExplicitGyroscopic& solver, const PrincipalInertia<double>& inertia, double spin,
                      double h) {
    return judge_adding(solver, inertia, spin, h, "each step adds h²/2 |I^(−1/2) (ω × Iω)|²");
}

SpinAdvice judge_spin(const LaggedInertia& solver, const PrincipalInertia<double>& inertia, double spin, double h) {
    return judge_adding(solver, inertia, spin, h, "keeps |L|; the energy may rise up to L² / (2 I_min)");
}

SpinAdvice judge_spin(const NoGyroscopic& solver, const PrincipalInertia<double>&, double, double h) {
    SpinAdvice advice = spin_advice(solver.name, h, 0);
    advice.reason = "ω stands still: no energy is added, and nothing tumbles";
    return advice;
}

SpinAdvice judge_spin(const ImplicitGyroscopic& solver, const PrincipalInertia<double>& inertia, double spin,
                      double h) {
    SpinAdvice advice = spin_advice(solver.name, h, 2);
    if ((inertia.ratio.array() == 0).any())
        return advice.reason = "two equal moments: the equations are linear, one iteration solves them", advice;
    advice.longest_step = longest_safe_step(inertia, spin);
    advice.verdict = verdict(h, advice.longest_step);
    advice.reason = "h|ω| = " + number(h * spin) + (h < advice.longest_step ? " < " : " ≥ ") +
                    number(advice.longest_step * spin) + " = √(I₁I₃) / (I₃ − I₁), least and largest moment";
    find_worst(advice, solver, inertia, spin, h);
    if (const double unbounded = unbounded_step(inertia, spin); h >= unbounded) {
        advice.worst_gain = std::numeric_limits<double>::infinity();
        advice.reason += "; from " + number(unbounded * spin) + " on without bound";
    }
    return advice;
}

SpinAdvice judge_spin(const ConvergedGyroscopic& solver, const PrincipalInertia<double>&, double, double h) {
    SpinAdvice advice = spin_advice(solver.name, h, 0);
    advice.cost = std::numeric_limits<double>::quiet_NaN();  // as many iterations as it takes
    advice.reason = "E₂ − E₁ = −½ (ω₂ − ω₁)·I(ω₂ − ω₁) for every step";
    return advice;
}

SpinAdvice judge_spin(const PassiveGyroscopic& solver, const PrincipalInertia<double>&, double, double h) {
    SpinAdvice advice = spin_advice(solver.name, h, 2);
    advice.reason = "|√I ω| never grows: with s = √I ω the step is s₂ − k × s₂ = s₁";
    return advice;
}

}  // namespace

const std::vector<GyroscopicSolver>& gyroscopic_solvers() {
    static const std::vector<GyroscopicSolver> all = [] {
        std::vector<GyroscopicSolver> made;
        for_each_gyroscopic([&](const auto& solver) {
            made.push_back(
                {solver.name,
                 [=](const auto& inertia, double spin, double h) { return judge_spin(solver, inertia, spin, h); },
                 [=](const auto& inertia, const auto& omega, double h) {
                     return energy_gain(solver, inertia, omega, h);
                 }});
        });
        return made;
    }();
    return all;
}

const GyroscopicSolver& gyroscopic_solver(std::string_view name) {
    for (const GyroscopicSolver& each : gyroscopic_solvers())
        if (name == each.name) return each;
    refuse("there is no gyroscopic solver \"" + std::string(name) + "\"");
}

std::vector<SpinAdvice> advise_spin(const PrincipalInertia<double>& inertia, double spin, double h) {
    positive("spin", spin);
    positive("step", h);
    positive("step times spin", h * spin);
    if (spin > 1e50) refuse("spin", spin, "at most 1e50");
    if (h * spin > 1e50) refuse("step times spin", h * spin, "at most 1e50");
    std::vector<SpinAdvice> all;
    for (const GyroscopicSolver& solver : gyroscopic_solvers()) all.push_back(solver.judge(inertia, spin, h));
    return all;
}

}  // namespace timestep
