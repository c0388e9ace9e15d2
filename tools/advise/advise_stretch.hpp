#pragma once
/// \file
/// Which steps are right? The first stretch of steps that are stable, as near as wanted, and free
/// of ringing (I13).

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "advise_frames.hpp"
#include "advise_motion.hpp"
#include "advise_verdict.hpp"

#if defined(__clang__)  // what is long double here is meant to be
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wdouble-promotion"
#endif

/// \cond
namespace timestep::detail {

// A method on one spring, and its type forgotten: what is said of it is compiled once for all of
// them.
struct Judged {
    const char* name;
    int work;  // evaluations and solves in a step
    bool takes_damping;
    bool one_pattern;     // steps of all lengths are functions of one matrix
    bool two_steps;       // it takes the last two states for one curve
    bool implicit_euler;  // the one with a proof for tethers
    bool new_damping;     // semi-implicit Euler with the damping at the new velocity
    StabilityLimit limit,
        least_limit;         // for the fastest oscillation, and for the slowest that it can be
    StabilityLimit at_once;  // the first of them where all dampers are solved for at once
    std::function<std::vector<Complex>(long double s)> multipliers;
    std::function<double(long double s)> position_error;
    MatrixOf matrix;  // of a step that is not like the one before
};

template <class Method>
const auto& when_step_changes(const Method& method) {
    return method;
}
inline const auto& when_step_changes(const Bdf2&) { return implicit_midpoint; }

// `several`: several dampers. `thrown`: the start that counts besides, see advise().
template <class Method>
Judged judged(const Method& method, double zeta, double least_zeta, bool several = false, bool thrown = false) {
    constexpr bool new_damping = std::is_same_v<Method, SemiImplicitEulerNewDamping>;
    const StabilityLimit at_once = stability_limit(method, zeta);
    return {method.name,
            method.cost.evaluations + method.cost.solves,
            Method::takes_damping,
            Method::steps_commute,
            std::is_same_v<Method, Bdf2>,
            std::is_same_v<Method, ImplicitEuler>,
            new_damping,
            new_damping && several && zeta > 0 ? StabilityLimit{2, "2"} : at_once,
            stability_limit(method, least_zeta),
            at_once,
            [=](long double s) { return multipliers(method, zeta, s); },
            [=](long double s) {
                const double let_go = position_error(method, zeta, s);
                return thrown ? std::fmax(let_go, velocity_error(method, zeta, s)) : let_go;
            },
            [=](long double s) { return matrix_of(when_step_changes(method), zeta, s); }};
}

// The position error of a constant step with ωh = s; infinite where it is not stable or rings.
inline double error_of(const Judged& method, double zeta, double s) {
    const bool fine = verdict(s, method.limit.value) == Verdict::stable && ringing(method.multipliers(s), zeta, s) == 0;
    return fine ? method.position_error(s) : std::numeric_limits<double>::infinity();
}

// The first stretch of s = ωh that are right; zeros where none is.
struct Stretch {
    double from = 0, to = 0;
};

// The error first rises from zero, but it need not go on rising: at longer steps errors of
// frequency and damping may come to cancel. Those steps are not searched for. We begin where
// roundoff alone is as much as wanted. The error has teeth: as s grows the last step leaves the
// first period, and what was farthest off is no longer looked at. It is largest at the end of a
// tooth, s = end/n, where n steps just fit into the period. So we go from such end to such end,
// skipping some where they are close or the error far below, then back to the first tooth that goes
// wrong, and within it by bisection.
inline Stretch first_right(const Judged& method, double zeta, double wanted) {
    const double slow = static_cast<double>(std::abs(exact_rate(zeta)));
    const double swing = 2 * std::numbers::pi / slow;
    const auto error = [&](double s) { return error_of(method, zeta, s); };
    const auto good = [&](double s) { return error(s) <= wanted; };
    const auto end_of = [&](double n) { return swing / n; };
    const double end = std::min(method.limit.value, 100 * (1 + zeta));  // by then the slow decay is over in a step
    double from = 1.0001 * static_cast<double>(rounded) / (wanted * slow);
    const double shortest = std::max(from, wanted / (10 + 20 * zeta));  // up to here the error rises
    const bool from_there = shortest < end && good(shortest);
    while (!from_there && from < end && !good(from)) from *= 1.05;
    if (!(from < end)) return {};
    double low = from_there ? shortest : from, high = low;
    double n = std::floor(swing / low);
    if (n > 1 && end_of(n) < low) --n;
    double right = n + 1;  // the last tooth that was right to its end
    while (n >= 1) {
        const double off = error(end_of(n));
        if (!(off <= wanted)) break;
        low = end_of(n), right = n;
        n = std::ceil(n / (off < wanted / 16 ? 2 : off < wanted / 4 ? 1.2 : 1.05)) - 1;
    }
    if (n >= 1) {
        double wrong = n;
        while (right - wrong > 1) {
            const double between = std::floor((right + wrong) / 2);
            (good(end_of(between)) ? right : wrong) = between;
        }
        low = std::max(low, end_of(right) * (1 + 1e-9)), high = end_of(wrong);
        if (!good(low)) low = std::max(shortest, end_of(right));
    } else {  // longer than an oscillation: no teeth
        high = low;
        while (good(high)) low = high, high *= 1.05;
    }
    for (int i = 0; i < 40; ++i) {
        const double middle = low + (high - low) / 2;
        (good(middle) ? low : high) = middle;
    }
    return {from, low};
}

}  // namespace timestep::detail
/// \endcond

#if defined(__clang__)
#pragma clang diagnostic pop
#endif
