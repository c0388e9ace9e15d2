#pragma once
/// \file
/// A damper and nothing else: what every method makes of a velocity that decays at the rate c/m
/// (I13).

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "advise_recommend.hpp"

#if defined(__clang__)  // what is long double here is meant to be
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wdouble-promotion"
#endif

namespace timestep {

/// \cond
namespace detail {

// a = −v: time is measured in m/c.
struct DamperAlone {
    long double acceleration(long double, long double v) const { return -v; }
    long double slope_x() const { return 0; }
    long double slope_v() const { return -1; }
};

// A method on it, its type forgotten. `start` is what the first step multiplies the velocity by,
// `factor` every later one.
struct JudgedDamper {
    const char* name;
    int work;
    bool takes_damping;
    double limit;  // the longest stable ch/m: that of a spring whose ζ grows without end
    std::function<long double(long double z)> start, factor;
};

template <class Method>
JudgedDamper judged_damper(const Method& method) {
    const int work = method.cost.evaluations + method.cost.solves;
    if constexpr (!Method::takes_damping) {
        return {method.name, work, false, 0, {}, {}};
    } else {
        const double hard = 1e8, limit = stability_limit(method, hard).value * 2 * hard;
        const auto first = [=](long double z) {
            const auto& stepping = when_step_changes(method);  // BDF2 starts with implicit midpoint
            return stepping.step(DamperAlone{}, State<long double>{0, 0, 1}, z).v;
        };
        JudgedDamper made{method.name, work, true, limit < 1e9 ? limit : std::numeric_limits<double>::infinity(),
                          first,       first};
        // Of BDF2's two factors, 1/(2 ± √(1 − 2z)), the larger; beyond z = 1/2 the size of both.
        if constexpr (std::is_same_v<Method, Bdf2>)
            made.factor = [](long double z) {
                return 2 * z < 1 ? 1 / (2 - std::sqrt(1 - 2 * z)) : 1 / std::sqrt(3 + 2 * z);
            };
        return made;
    }
}

TIMESTEP_WHERE_CALLED
std::vector<JudgedDamper> judged_dampers() {
    std::vector<JudgedDamper> all;
    const auto add = [&](const auto& method) { all.push_back(judged_damper(method)); };
    for_each_method(add);
    add(semi_implicit_euler_new_damping);
    for_each_verlet_method(add);
    return all;
}

// The largest error of the velocity, over the first one, until 2π m/c; eight steps where fewer than
// three fit.
inline double damper_error(const JudgedDamper& method, double z) {
    const double fit = std::floor(2 * std::numbers::pi / z * (1 + 1e-12));
    const bool two_steps = std::string_view(method.name) == bdf2.name;
    const long double first = method.start(z), factor = method.factor(z);
    long double most = rounded / z;
    if (fit > 512) {  // 256 of them: at the top, where zn is 1, they miss a curve like t e^(−t) by
                      // 8e-5 of it at most
        const long double other =
            two_steps ? 1 / (2 + std::sqrt(1 - 2 * static_cast<long double>(z))) : 0;  // soon gone
        const long double share = two_steps ? (first - other) / (factor - other) : 1;
        for (int k = 1; k <= 256; ++k) {
            const long double n = std::floor(fit * k / 256);
            most = std::max(most, std::abs(share * std::pow(factor, n) - std::exp(-n * z)));
        }
        return static_cast<double>(most);
    }
    const long double left = std::exp(-static_cast<long double>(z));
    long double before = 1, now = first, truth = left;
    for (int n = 1; n <= (fit < 3 ? 8 : static_cast<int>(fit)); ++n, truth *= left) {
        most = std::max(most, std::abs(now - truth));
        const long double next = two_steps ? (4 * now - before) / (3 + 2 * static_cast<long double>(z)) : factor * now;
        before = now, now = next;
    }
    return static_cast<double>(most);
}

// How wrong the rate of the decay is; NaN where the velocity turns its sign.
inline double damper_rate_error(const JudgedDamper& method, double z) {
    const long double factor = method.factor(z);
    return factor > 0 ? static_cast<double>(std::abs(-std::log(factor) / z - 1))
                      : std::numeric_limits<double>::quiet_NaN();
}

// The end of the stretch of right ch/m. It begins below 2 `wanted`: a method of order one is off by
// z/(2e) there.
inline double right_damper_step(const JudgedDamper& method, double wanted) {
    const auto good = [&](double z) {
        return verdict(z, method.limit) == Verdict::stable && method.factor(z) >= rings_below &&
               damper_error(method, z) <= wanted;
    };
    double low = wanted, high = 2 * wanted;
    while (high < 1e3 && good(high)) low = high, high *= 1.05;
    for (int i = 0; i < 40; ++i) {
        const double middle = low + (high - low) / 2;
        (good(middle) ? low : high) = middle;
    }
    return low;
}

inline Advice advise_damper(const JudgedDamper& method, double rate, double h, double wanted) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), z = rate * h;
    if (!method.takes_damping)
        return {
            method.name, Verdict::refused, "takes forces of the position only", nan, nan, nan, nan, nan, nan, nan, nan,
            nan};
    Advice advice;
    const long double factor = method.factor(z), size = std::abs(factor);
    advice.method = method.name;
    advice.verdict = verdict(z, method.limit);
    const std::string left = number(z), right = number(method.limit);
    advice.reason = !std::isfinite(method.limit) ? "stable for every step"
                    : left == right              ? "hc/m = " + left + ", the limit itself"
                                                 : "hc/m = " + left + (z < method.limit ? " < " : " > ") + right;
    advice.longest_step = method.limit / rate;
    advice.growth_per_step = static_cast<double>(size);
    advice.growth_per_second = static_cast<double>(std::exp(std::log(size) / h));
    const long double energy = 2 * (std::log(size) / h + rate);
    advice.energy_ratio = static_cast<double>(std::exp(energy)),
    advice.energy_drift = static_cast<double>(std::expm1(energy));
    advice.period_error = nan;
    advice.position_error = damper_error(method, z);
    advice.rate_error = damper_rate_error(method, z);
    advice.cost = method.work / h, advice.step = h;
    if (advice.verdict == Verdict::stable && factor < rings_below) {
        advice.ringing = static_cast<double>(factor);
        advice.reason = "stable, but rings: a step multiplies the velocity by −" + number(static_cast<double>(size), 3);
    }
    advice.right = advice.verdict == Verdict::stable && advice.ringing == 0 && advice.position_error <= wanted;
    advice.accurate_from = static_cast<double>(rounded) / wanted / rate;
    advice.accurate_step = right_damper_step(method, wanted) / rate;
    advice.accurate_cost = method.work / advice.accurate_step;
    return advice;
}

}  // namespace detail
/// \endcond

/// What every method makes of a velocity that a damper alone slows down, v' = −rate v with `rate` =
/// c/m in 1/s, at steps of `h` seconds. Advice::position_error is that of the **velocity** here:
/// the largest error, over the velocity at the start, until 2π/rate. The exact step multiplies it
/// by e^(−h rate). Throws `std::invalid_argument` where the rate or the step is not above zero and
/// finite, their product is not from 1e-12 to 1e12, or `wanted` is not from 1e-8 to 0.5.
TIMESTEP_WHERE_CALLED
std::vector<Advice> advise_damper(double rate, double h, double wanted = 0.01) {
    positive("damping over mass", rate);
    positive("step", h);
    if (!(rate * h >= 1e-12 && rate * h <= 1e12))
        refuse("step times damping over mass", rate * h, "from 1e-12 to 1e12");
    if (!(wanted >= 1e-8 && wanted <= 0.5)) refuse("accuracy", wanted, "from 1e-8 to 0.5");
    std::vector<Advice> all;
    for (const auto& method : detail::judged_dampers()) all.push_back(detail::advise_damper(method, rate, h, wanted));
    return all;
}

/// The answer for a damper alone: down the list of which_method.hpp, or, asked for an accuracy, the
/// method that reaches it at the least cost in whole substeps of `h`.
TIMESTEP_WHERE_CALLED
Recommendation recommend_damper(double rate, double h, const Wish& wish, const std::vector<Advice>& all) {
    const Choice& row = choice(wish.precise ? "smooth" : rate * h > ended_swing ? "pull" : "swing");
    Recommendation made{&row, 1, row.method, row.take, row.why};
    if (row.name == "swing") {
        made.take = "**semi-implicit Euler**, with the damping at the new velocity";
        made.why = "one division per step, by 1 + hc/m, which no damping makes unstable";
    }
    if (wish.precise) {
        double least = std::numeric_limits<double>::infinity();
        for (const Advice& each : all) {
            const double step = best_step(each, h);
            const long n = step > 0 ? detail::pieces(h, step) : 0;
            if (n == 0 || !(each.cost * double(n) < least)) continue;
            least = each.cost * double(n), made.substeps = n, made.method = each.method;
        }
        made.take = "**" + made.method + "**",
        made.why = "as accurate as you asked, at the least cost in whole substeps";
        if (std::isinf(least)) made.substeps = 0;
    }
    for (const auto& method : detail::judged_dampers()) {
        if (made.method != method.name || made.substeps == 0) continue;
        const double z = rate * h / double(made.substeps);
        made.position_error = detail::damper_error(method, z), made.rate_error = detail::damper_rate_error(method, z);
    }
    return made;
}

}  // namespace timestep

#if defined(__clang__)
#pragma clang diagnostic pop
#endif
