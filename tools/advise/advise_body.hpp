#pragma once
/// \file
/// Which solver for my spinning body? Whether each can ever add energy, what each makes of the very
/// throw that was asked about, and which one to take (N51, I13).

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "advise_spin.hpp"
#include <timestep/body_solvers.hpp>
#include <timestep/body_throw.hpp>
#include "which_method.hpp"

namespace timestep {

/// Can a solver ever add energy to a body that is left alone, whatever the direction of its spin?
enum class AddsEnergy {
    never,              ///< not in any number of steps
    bounded,            ///< it may, but never has the body more than so many times its first
    one_step_can,       ///< in some direction one step does; how far many of them get is not known
    too_close_to_call,  ///< within 0.1 % of the limit, or no more than roundoff
};

/// The answer in words.
inline const char* words(AddsEnergy answer) {
    constexpr std::array all{"never", "bounded", "one step can", "too close to call"};
    return all[static_cast<std::size_t>(answer)];
}

/// What one solver can make of a spinning body.
struct BodyAdvice {
    std::string method;                   ///< its name
    AddsEnergy adds = AddsEnergy::never;  ///< can it ever add energy?
    double bound = 1;                     ///< times its first energy, and never more; infinite where no bound is known
    std::string reason;                   ///< the formula that says so, with its numbers
    double worst_gain = 1;                ///< where one step can: what the worst one found multiplies the energy by
    Vector3<double> worst_spin = Vector3<double>::Zero();  ///< the spin that gains it, rad/s in body coordinates
    double longest_step = std::numeric_limits<double>::infinity();  ///< up to which that verdict is no worse, s;
                                                                    ///< 0: every step adds
    BodyPrice price;                                                ///< what a step computes
    Thrown thrown;                                                  ///< what the throw that was asked about came to
};

/// \cond
namespace detail {

// Of the moments I₁ ≤ I₂ ≤ I₃: (I₂ − I₁)(I₃ − I₂)/(I₁I₃). By the triangle rule it is below 1, and
// it is 0 where two are equal.
inline double middle_share(const PrincipalInertia<double>& inertia) {
    const Vector3<double>& a = inertia.ratio;
    return std::max({0.0, a.x() * a.y(), a.y() * a.z(), a.z() * a.x()});
}
inline double moment_ratio(const PrincipalInertia<double>& inertia) {
    return inertia.unit.maxCoeff() / inertia.unit.minCoeff();
}
inline bool two_equal(const PrincipalInertia<double>& inertia) { return (inertia.ratio.array() == 0).any(); }

template <class Rule>
void find_worst(BodyAdvice& advice, const Rule& rule, const PrincipalInertia<double>& inertia, double spin, double h) {
    const PrincipalInertia<double> body = inertia.scaled_to_one();
    const auto gain = [&](const Vector3<double>& direction) {
        const Vector3<double> omega = h * spin * direction;  // |ω| may be any size
        const SpinState<double> s{0, Quaternion<double>::Identity(), omega};
        return kinetic_energy(body, Vector3<double>(rule.step(body, s, 1.0).omega)) / kinetic_energy(body, omega);
    };
    const Worst worst = worst_direction(gain, std::numeric_limits<double>::infinity());
    advice.worst_gain = std::max(worst.gain, 1.0);
    advice.worst_spin = spin * worst.direction;
    if (worst.gain > 1 + more_than_roundoff) return;
    advice.adds = AddsEnergy::too_close_to_call;
    advice.reason += "; here less than 1e-12 of the energy, lost in roundoff";
}

// The solvers of chapter 5, from what one step of theirs can do.
template <class Solver>
void judge(BodyAdvice& advice, const Tumble<Solver>&, const PrincipalInertia<double>& inertia, double spin, double h,
           bool) {
    const SpinAdvice one = advise_spin(Solver{}, inertia, spin, h);
    advice.adds = one.verdict == Verdict::stable  ? AddsEnergy::never
                  : one.verdict == Verdict::grows ? AddsEnergy::one_step_can
                                                  : AddsEnergy::too_close_to_call;
    advice.reason = one.reason;
    advice.longest_step = one.longest_step;
    advice.bound = advice.adds == AddsEnergy::never ? 1 : std::numeric_limits<double>::infinity();
    if (advice.adds == AddsEnergy::never) return;
    advice.worst_gain = one.worst_gain;
    advice.worst_spin = one.worst_spin;
}

TIMESTEP_WHERE_CALLED
void judge(BodyAdvice& advice, const LaggedInertiaSpin&, const PrincipalInertia<double>& inertia, double spin, double h,
           bool even) {
    judge(advice, Tumble<LaggedInertia>{}, inertia, spin, h, even);
    if (advice.adds == AddsEnergy::never) return;
    advice.bound = moment_ratio(inertia);
    advice.reason =
        "every step may add; |L| stays, so at most I_max/I_min = " + number(advice.bound) + " times the first";
}

// It keeps E/Δ with Δ = 1 − c (hω₂/2)², ω₂ that about the axis of the intermediate moment and c the
// middle share. As Δ is at most 1, E is never more than the first one over the first Δ, while that
// is above zero.
TIMESTEP_WHERE_CALLED
void judge(BodyAdvice& advice, const Tumble<HalfStepJacobian>& rule, const PrincipalInertia<double>& inertia,
           double spin, double h, bool even) {
    const double share = middle_share(inertia);
    if (share == 0) return void(advice.reason = "two equal moments: the energy stays");
    const double root = std::sqrt(share) * (h * spin / 2), left = 1 - root * root;
    advice.longest_step = 2 / std::sqrt(share) / spin;
    const Verdict side = verdict(root, 1);
    const std::string formula = "E/(1 − c (hω₂/2)²) stays, c = (I₂−I₁)(I₃−I₂)/(I₁I₃) = " + number(share);
    advice.bound = std::numeric_limits<double>::infinity();
    if (side == Verdict::stable && even) {
        advice.adds = AddsEnergy::bounded;
        advice.bound = 1 / left;
        advice.reason = formula + ": c (h|ω|/2)² = " + number(root * root) + " < 1; for every body h|ω| < 2 will do";
        return;
    }
    advice.adds = AddsEnergy::one_step_can;
    if (side == Verdict::stable) {
        advice.longest_step = 0;
        advice.reason =
            "frame by frame the energy may rise × " + number(1 / left) + ": the bound is that of a constant step";
        return find_worst(advice, rule, inertia, spin, h);
    }
    advice.reason = formula + ": c (h|ω|/2)² = " + number(root * root) + ", and from 1 on the Jacobian can be singular";
    if (side != Verdict::grows) return void(advice.adds = AddsEnergy::too_close_to_call);
    advice.worst_gain = std::numeric_limits<double>::infinity();
    advice.worst_spin = Vector3<double>::Zero();
}

inline void judge(BodyAdvice& advice, const Tumble<CayleyGyroscopic>&, const PrincipalInertia<double>&, double, double,
                  bool) {
    advice.reason = "√I ω is turned: the energy stays, whatever the step";
}

inline void judge(BodyAdvice& advice, const Tumble<CalmHalfStep>&, const PrincipalInertia<double>&, double, double,
                  bool) {
    advice.reason = "scaled back to the energy that the step began with, whatever the step";
}

inline void by_momentum(BodyAdvice& advice, const PrincipalInertia<double>& inertia) {
    advice.bound = moment_ratio(inertia);
    advice.adds = AddsEnergy::bounded;
    advice.reason = "|L| stays and E ≤ |L|²/2I_min: at most I_max/I_min = " + number(advice.bound) + " times the first";
}
inline void judge(BodyAdvice& advice, const Strang&, const PrincipalInertia<double>& inertia, double, double, bool) {
    if (no_torque(inertia)) return void(advice.reason = "equal moments: the energy is |L|²/2I, and |L| stays");
    by_momentum(advice, inertia);
}
template <class Rule>
void judge_remainder(BodyAdvice& advice, const Rule&, const PrincipalInertia<double>& inertia) {
    if (two_equal(inertia)) return void(advice.reason = "two equal moments: the exact motion");
    by_momentum(advice, inertia);
}
inline void judge(BodyAdvice& advice, const BallAndRemainder2& rule, const PrincipalInertia<double>& inertia, double,
                  double, bool) {
    judge_remainder(advice, rule, inertia);
}
inline void judge(BodyAdvice& advice, const BallAndRemainder4& rule, const PrincipalInertia<double>& inertia, double,
                  double, bool) {
    judge_remainder(advice, rule, inertia);
}

// With two equal moments the other two components of ω go round with the angle
// h·precession_ratio·ω_z a step, and chapter 3's 2√2 is the limit.
TIMESTEP_WHERE_CALLED
void judge(BodyAdvice& advice, const RungeKuttaSpin& rule, const PrincipalInertia<double>& inertia, double spin,
           double h, bool) {
    if (no_torque(inertia)) return void(advice.reason = "equal moments: no gyroscopic torque");
    const double limit = 2 * std::sqrt(2.0);
    advice.bound = std::numeric_limits<double>::infinity();
    if (two_equal(inertia)) {
        const double wobble = inertia.ratio.cwiseAbs().maxCoeff();
        advice.longest_step = limit / wobble / spin;
        const Verdict side = verdict(h * spin * wobble, limit);
        advice.reason = "two equal moments: h|ω| |I_along − I_across|/I_across = " + number(h * spin * wobble) +
                        (side == Verdict::grows ? " > 2√2" : " < 2√2");
        if (side == Verdict::stable) return void(advice.bound = 1);
        advice.adds = side == Verdict::grows ? AddsEnergy::one_step_can : AddsEnergy::too_close_to_call;
        if (side != Verdict::grows) return;
    } else {
        advice.adds = AddsEnergy::one_step_can;
        advice.longest_step = 0;
        advice.reason =
            "keeps nothing: a step changes the energy by a share that goes with (h|ω|)⁵, up or "
            "down";
    }
    find_worst(advice, rule, inertia, spin, h);
}

// The verdict alone: is a body that spins with `spin` rad/s, in any direction, ever given energy?
template <class Rule>
BodyAdvice judged(const Rule& rule, const BodyPrice& price, const PrincipalInertia<double>& inertia, double spin,
                  double h, bool even = true) {
    BodyAdvice advice;
    advice.method = Rule::name;
    advice.price = price;
    judge(advice, rule, inertia, spin, h, even);
    return advice;
}

inline void check_spin(double spin, double h) {
    positive("spin", spin);
    positive("step times spin", h * spin);
    if (spin > 1e50) refuse("spin", spin, "at most 1e50");
    if (h * spin > 1e50) refuse("step times spin", h * spin, "at most 1e50");
}

}  // namespace detail
/// \endcond

/// What every solver of chapters 5 and 8 makes of a body that spins with `omega`, rad/s in its own
/// axes, in frames of these lengths. The verdict is for any direction of a spin so fast, and for
/// steps as long as the longest; the throw is of `omega` itself, tilted as as_thrown() has it.
///
/// Throws `std::invalid_argument` where the spin is not above zero and finite, or it or its product
/// with a step is above 1e50: some of the solvers' products would overflow.
TIMESTEP_WHERE_CALLED
std::vector<BodyAdvice> advise_body(const PrincipalInertia<double>& inertia, const Vector3<double>& omega,
                                    const Frames& frames) {
    const double spin = omega.stableNorm(), h = frames.longest();
    detail::check_spin(spin, h);
    const Vector3<double> tilted = as_thrown(omega);
    std::vector<BodyAdvice> all;
    for_each_body_solver([&](const auto& rule, const BodyPrice& price) {
        all.push_back(detail::judged(rule, price, inertia, spin, h, frames.even()));
        all.back().thrown = throw_body(rule, inertia, tilted, frames);
    });
    return all;
}

/// Which one to take.
struct BodyRecommendation {
    Choice choice;           ///< the answer of which_method.hpp
    long long substeps = 1;  ///< in so many of them a frame
};

/// \cond
namespace detail {
// |ω̇| is at most a |ω|²/√3, a the largest of the ratios. So a body that is turned by its first ω is
// off by at most a (|ω| t)²/2√3 after t seconds, and t is two. (A third instead of 1/2√3: |ω| grows
// by a share of a at most.)
inline bool passes_for_ball(const PrincipalInertia<double>& inertia, double spin) {
    const double a = inertia.ratio.cwiseAbs().maxCoeff();
    return a <= nearly_equal && a * (2 * spin) * (2 * spin) / 3 <= right_orientation;
}

// Two nearly equal moments count as equal if the step for equal moments is accurate for this body.
// In the air that step is ball and remainder 2, with the true moments, and the given throw decides:
// the step may be accurate about the length and wrong across it. For a callback the step is one
// Newton step, which must add next to no energy in any direction, as contacts turn the spin. With
// contacts alone the calm half-step of three moments is all but that of two.
inline bool passes_for_symmetric(const PrincipalInertia<double>& inertia, const Vector3<double>& omega,
                                 const Frames& frames, bool contacts, bool callback) {
    if (!closest_moments(inertia).all_but_equal() || contacts != callback) return false;
    const double turn = frames.longest() * omega.stableNorm();
    if (callback)
        return turn < unbounded_step(inertia, 1) &&
               worst_direction(ImplicitGyroscopic{}, inertia, turn, 1, 1.001).gain <= 1.001;
    return throw_body(ball_and_remainder_2, inertia, as_thrown(omega), frames, 2).off <= right_orientation;
}
}  // namespace detail
/// \endcond

/// The recommendation for this body, spun with `omega` (rad/s, in the body's axes). Throws
/// `std::invalid_argument` if the spin is not above zero and finite, or so fast that a free body
/// would need more than 1e9 substeps.
TIMESTEP_WHERE_CALLED
BodyRecommendation recommend(const PrincipalInertia<double>& inertia, const Vector3<double>& omega,
                             const Frames& frames, bool contacts = false, long count = 1, bool callback = false) {
    const Vector3<double>& I = inertia.moments;
    const double spin = omega.stableNorm(), turn = frames.longest() * spin;
    detail::check_spin(spin, frames.longest());
    const double most = frames.even() ? fair_turn : fair_uneven_turn;
    if (turn > 1e9 * most)
        refuse("spin", spin,
               ("so slow that a step turns the body by at most " + detail::number(1e9 * most) +
                " rad, 1e9 substeps of " + detail::number(most))
                   .c_str());
    BodyQuestion question{{I.x(), I.y(), I.z()}, turn, contacts, count, frames.even(), callback};
    question.is_ball = detail::passes_for_ball(inertia, spin);
    question.is_symmetric = detail::passes_for_symmetric(inertia, omega, frames, contacts, callback);
    BodyRecommendation found{choose(question), 1};
    const double fair = found.choice.name == "free_fast"     ? fair_turn
                        : found.choice.name == "free_uneven" ? fair_uneven_turn
                                                             : turn;
    // 15 rad/s at 60 Hz is a quarter, whatever its last digit.
    found.substeps = std::llround(std::max(std::ceil(turn / fair * (1 - 1e-12)), 1.0));
    return found;
}

}  // namespace timestep
