#pragma once
/// \file
/// Which method, what does it cost, will my simulation blow up, how far is it from the truth? For a
/// spring with a damper, what every method makes of it at a given step: predicted, without a single
/// step of simulation (I13).

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "advise_stretch.hpp"
#include <timestep/inline.hpp>

#if defined(__clang__)  // what is long double here is meant to be
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wdouble-promotion"
#endif

namespace timestep {

/// What one method makes of a spring. Numbers that mean nothing here are NaN.
struct Advice {
    std::string method;        ///< its name
    Verdict verdict;           ///< will it blow up?
    std::string reason;        ///< the formula that says so, with its numbers
    double longest_step;       ///< the longest stable step, s; infinite where there is no limit
    double growth_per_step;    ///< what a step multiplies the amplitude by in the long run
    double growth_per_second;  ///< the same for a second of game time
    double energy_ratio;       ///< the energy after a second over what it should be
    double energy_drift;       ///< that minus one
    double period_error;       ///< the period over the exact one, minus one
    double position_error;     ///< the farthest from the true place in the first period, over the
                               ///< start: see advise()
    double rate_error;         ///< how wrong the motion's frequency and decay are: see advise()
    double cost;               ///< force evaluations and solves in a second of game time
    double accurate_step = 0;  ///< the end of the first stretch of right steps, s; 0: there is none
    double accurate_cost = 0;  ///< what that costs, evaluations and solves a second; 0 if there is none
    double ringing = 0;        ///< what a step multiplies the part by that rings, below −1/2; 0: none does
    double accurate_from = 0;  ///< where that stretch begins, s: below roundoff is too much
    double step = 0;           ///< the step that was asked about, s
    bool right = false;        ///< is that one stable and as near as wanted, and nothing rings?
};

/// Stable, and yet it keeps four times the energy that it should, twice the amplitude, while a
/// hundredth of the start is there to be seen.
inline bool lingers(const Advice& advice) { return advice.energy_ratio > 4 && advice.growth_per_second >= 0.01; }

/// The verdict in words, and beside "stable" what is alarming all the same: stable is not right.
inline std::string told_verdict(const Advice& advice) {
    if (advice.verdict != Verdict::stable) return words(advice.verdict);
    if (advice.ringing < 0) return "stable, rings";
    if (advice.position_error > 0.5) return "stable, far off";
    return lingers(advice) ? "stable, lingers" : "stable";
}

/// \cond
namespace detail {

inline Said judge(const Judged& method, const SpringScene& scene, double h, const Growth& growth,
                  const std::vector<StepMatrix<double>>& steps) {
    const double omega = scene.fastest.omega;
    const bool sweep = scene.several && method.new_damping && scene.fastest.zeta > 0;
    const Said constant = sweep ? several_dampers(scene, h, method.at_once, method.least_limit)
                                : constant_step(scene, h, method.limit, method.least_limit);
    if (scene.only_pulls) {
        const Said taut = tether(constant, method.implicit_euler && !scene.turns);
        const bool surely_grows = taut.verdict == Verdict::grows && !scene.varying();
        if (taut.verdict == Verdict::stable || surely_grows || !scene.varying()) return taut;
        return {Verdict::not_proven, taut.reason};
    }
    if (!scene.varying()) return constant;
    Said said = varying_steps(method.one_pattern, method.limit, omega * scene.shortest_frame,
                              omega * scene.longest_frame, steps, growth);
    // Of the slower oscillations that the fastest one may be nothing more is known.
    if (scene.bounded() && said.verdict == Verdict::grows) said.verdict = Verdict::not_proven;
    // One ellipse holds one oscillation.
    if ((scene.bounded() || scene.several) && !method.one_pattern && said.verdict == Verdict::stable &&
        std::isfinite(method.limit.value))
        return {Verdict::not_proven, "proven for the fastest oscillation alone"};
    return said;
}

// All but the first stretch.
inline Advice at_step(const Judged& method, const SpringScene& scene, double h, double wanted) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const DampedSpring<double>& spring = scene.fastest;
    if (!method.takes_damping && spring.zeta > 0)
        return {
            method.name, Verdict::refused, "takes forces of the position only", nan, nan, nan, nan, nan, nan, nan, nan,
            nan};

    const double s = spring.omega * h, zeta = spring.zeta;
    const auto all = method.multipliers(s);
    const Complex lambda = all.front(), exact = exact_rate(zeta);
    long double largest = 0;
    for (const Complex& each : all) largest = std::max(largest, std::abs(each));

    Advice advice;
    advice.method = method.name;
    advice.longest_step = method.limit.value / spring.omega;
    advice.position_error = method.position_error(s);
    advice.rate_error = rate_error(all, zeta, s);
    long double growth_per_step = std::log(largest);
    double mean_step = h;
    Growth growth{0, 0};
    std::vector<StepMatrix<double>> steps;
    if (scene.varying()) {
        const double shortest = spring.omega * scene.shortest_frame, longest = spring.omega * scene.longest_frame;
        steps = steps_of(method.matrix, shortest, longest);
        growth = method.one_pattern ? mean_growth(steps, zeta) : random_products(steps);
        growth_per_step = growth.mean;
        mean_step = (scene.shortest_frame + scene.longest_frame) / 2;
        advice.position_error = random_position_error(method.matrix, method.position_error,
                                                      DampedSpring<long double>(1, zeta), shortest, longest);
    }
    const Said said = judge(method, scene, h, growth, steps);
    advice.verdict = said.verdict;
    advice.reason = said.reason;
    // What a tether does when it is slack, and what is not known of the springs, is not the
    // oscillation's affair.
    const bool taut = scene.only_pulls && advice.verdict == Verdict::not_proven;
    if (advice.verdict == Verdict::stable || taut) {
        const long double most = ringing(all, zeta, s);
        advice.ringing = static_cast<double>(most);
        if (most < 0 && advice.verdict == Verdict::stable) {
            const std::string why = ringing_words(all, most, zeta);
            advice.reason = std::isfinite(method.limit.value) ? why + "; " + advice.reason : why;
        }
    }
    advice.growth_per_step = static_cast<double>(std::exp(growth_per_step));
    advice.growth_per_second = static_cast<double>(std::exp(growth_per_step / mean_step));
    const long double energy_rate = 2 * (growth_per_step / mean_step - exact.real() * spring.omega);
    advice.energy_ratio = static_cast<double>(std::exp(energy_rate));
    advice.energy_drift = static_cast<double>(std::expm1(energy_rate));
    advice.period_error =
        exact.imag() > 0 && lambda.imag() > 0 ? static_cast<double>(exact.imag() * s / std::arg(lambda) - 1) : nan;
    advice.cost = method.work / mean_step;
    advice.step = h;
    if (scene.kicks && method.two_steps) advice.reason += "; restart it after each kick, or 1 m/s becomes 1.5";
    advice.right =
        (advice.verdict == Verdict::stable || taut) && advice.ringing == 0 && advice.position_error <= wanted;
    return advice;
}

inline Advice advise(const Judged& method, const SpringScene& scene, double h, double wanted) {
    const DampedSpring<double>& spring = scene.fastest;
    Advice advice = at_step(method, scene, h, wanted);
    if (scene.varying() || advice.verdict == Verdict::refused) return advice;
    if (const Stretch stretch = first_right(method, spring.zeta, wanted); stretch.to > 0) {
        advice.accurate_from = stretch.from / spring.omega;
        advice.accurate_step = stretch.to / spring.omega;
        advice.accurate_cost = method.work / advice.accurate_step;
    }
    return advice;
}
template <class Method>
Advice advise(const Method& method, const SpringScene& scene, double h, double wanted) {
    return advise(judged(method, scene.fastest.zeta, scene.least.zeta, scene.several, scene.thrown), scene, h, wanted);
}

}  // namespace detail
/// \endcond

/// What every method of the course makes of the fastest oscillation of `scene`, which may be just
/// one DampedSpring, at steps of `h` seconds, in the order in which the course meets them. With
/// frames of uneven length `h` is the longest of them.
///
/// **The error that counts is the one that is seen**: let the spring go at rest, and compare the
/// positions after every step of the first period, 2π/ω, with the exact ones. The largest distance,
/// as a share of the start, is Advice::position_error. (Beyond ζ = 1 the time looked at is 2π over
/// the slow decay's rate; one step at least, and eight where fewer than three would fit.) Beyond ζ
/// = 5.1 the fast decay is hidden in these positions. If at least three steps `h` fit into 2π/q,
/// where q is the rate of that decay, a second start counts as well: the body is thrown from its
/// rest position. Advice::position_error is then the larger of the two errors; the second is that
/// of the velocity, relative to the throw's. A velocity that belongs half a step earlier, as
/// semi-implicit Euler's, moves the whole motion in time: that is seen, and it counts.
///
/// Growth, period and energy are those of the step's eigenvalues, in the long run. Of the motion
/// e^(μt) a step makes e^((ln λ / h) t), so |ln λ / h − μ| / |μ| is how wrong its rate is,
/// frequency and decay together: Advice::rate_error. Near ζ = 1 the two rates of a spring meet, and
/// tiny changes of it drive them far apart. There the step's motion is compared as a whole: it is
/// that of another spring, ω' and ζ', and the error is |ω' − ω|/ω and |ζ'ω' − ζω|/ω together
/// (beyond ζ = 1 the latter is |ζ'ω' − ζω|/(ζω)). The smaller of the two counts. In both errors
/// roundoff counts: in double, a step that changes the state only by a share δ is off by up to
/// 2⁻⁵³/δ.
///
/// `wanted` is how large the position error may be. A step is **right** if it is stable, the error
/// is no larger, and nothing rings. Told are whether the step `h` is, and the end of the first
/// stretch of right steps. Longer ones may be right again, by errors that happen to cancel; of
/// those only `h` itself is looked at. (A tether is judged right while it is taut.)
///
/// A stable method may still **ring**: a step multiplies a part that should decay by less than
/// −1/2, and it shakes from step to step. Then the advice says so.
///
/// A force evaluation and a solve are counted as equal in cost. Throws `std::invalid_argument`
/// where ω or h is not above zero and finite, where ωh is below 1e-12 (a step then changes nothing
/// but the last digits) or not finite, or `wanted` is not between 1e-8 and 0.5.
TIMESTEP_WHERE_CALLED
std::vector<Advice> advise(SpringScene scene, double h, double wanted = 0.01) {
    const double omega = scene.fastest.omega;
    positive("omega", omega);
    positive("step", h);
    if (!std::isfinite(omega * h)) refuse("step", h, "so short that omega times it is finite");
    const double shortest = scene.varying() ? scene.shortest_frame : h;
    if (omega * shortest < 1e-12) refuse("step", shortest, "so long that omega times it is 1e-12 or more");
    if (!(wanted >= 1e-8 && wanted <= 0.5)) refuse("accuracy", wanted, "from 1e-8 to 0.5");
    scene.thrown = detail::thrown_counts(scene.fastest.zeta, omega * h);
    std::vector<Advice> all;
    const auto add = [&](const auto& method) { all.push_back(detail::advise(method, scene, h, wanted)); };
    for_each_method(add);
    add(semi_implicit_euler_new_damping);
    for_each_verlet_method(add);
    return all;
}

/// The longest step known to be right and no longer than `longest`, in seconds; 0 if there is none.
inline double best_step(const Advice& advice, double longest = std::numeric_limits<double>::infinity()) {
    const double best = advice.accurate_from <= longest ? std::min(advice.accurate_step, longest) : 0;
    return advice.right && advice.step <= longest ? std::max(best, advice.step) : best;
}

/// What the method costs a second at best_step().
inline double best_cost(const Advice& advice, double longest = std::numeric_limits<double>::infinity()) {
    const double step = best_step(advice, longest);
    return step > 0 ? advice.cost * (advice.step / step) : 0;
}

/// Of the methods that stay as near as wanted the one that does so at the least cost, with steps no
/// longer than `longest`; of equally cheap ones the one that stays nearer. Null where none does.
inline const Advice* cheapest(const std::vector<Advice>& all,
                              double longest = std::numeric_limits<double>::infinity()) {
    const Advice* best = nullptr;
    for (const Advice& advice : all) {
        if (!(best_step(advice, longest) > 0)) continue;
        const double ratio = best ? best_cost(advice, longest) / best_cost(*best, longest) : 0;
        const bool alike = std::abs(ratio - 1) < 1e-9;
        if (alike ? advice.position_error < best->position_error : ratio < 1) best = &advice;
    }
    return best;
}

}  // namespace timestep

#if defined(__clang__)
#pragma clang diagnostic pop
#endif
