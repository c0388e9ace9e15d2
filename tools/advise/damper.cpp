// A damper and nothing else: what every method makes of a velocity that decays at the rate c/m.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <timestep/checks.hpp>

#include "method_on_spring.hpp"

#if defined(__clang__)  // what is long double here is meant to be
#pragma clang diagnostic ignored "-Wdouble-promotion"
#endif

namespace timestep {

namespace {

// a = −v: time is measured in m/c.
struct DamperAlone {
    long double acceleration(long double, long double v) const { return -v; }
    long double slope_x() const { return 0; }
    long double slope_v() const { return -1; }
};

// A method on it, its type forgotten. `start` is what the first step multiplies the velocity by,
// `factor` every later one.
struct MethodOnDamper {
    const char* name;
    int work;
    bool takes_damping;
    double limit;  // the longest stable ch/m: that of a spring whose ζ grows without end
    std::function<long double(long double z)> start, factor;
};

template <class Method>
MethodOnDamper on_damper(const Method& method) {
    const int work = method.cost.evaluations + method.cost.solves;
    if constexpr (!Method::takes_damping) {
        return {method.name, work, false, 0, {}, {}};
    } else {
        const double hard = 1e8, limit = stability_limit(method, hard).value * 2 * hard;
        const auto first = [=](long double z) {
            const auto& stepping = when_step_changes(method);  // BDF2 starts with implicit midpoint
            return stepping.step(DamperAlone{}, State<long double>{0, 0, 1}, z).v;
        };
        MethodOnDamper made{method.name, work, true, limit < 1e9 ? limit : std::numeric_limits<double>::infinity(),
                            first,       first};
        // Of BDF2's two factors, 1/(2 ± √(1 − 2z)), the larger; beyond z = 1/2 the size of both.
        if constexpr (std::is_same_v<Method, Bdf2>)
            made.factor = [](long double z) {
                return 2 * z < 1 ? 1 / (2 - std::sqrt(1 - 2 * z)) : 1 / std::sqrt(3 + 2 * z);
            };
        return made;
    }
}

std::vector<MethodOnDamper> methods_on_damper() {
    std::vector<MethodOnDamper> all;
    for_each_spring_method([&](const auto& method) { all.push_back(on_damper(method)); });
    return all;
}

// The largest error of the velocity, over the first one, until 2π m/c; eight steps where fewer than
// three fit.
double damper_error(const MethodOnDamper& method, double z) {
    const double fit = std::floor(2 * 3.141592653589793 / z * (1 + 1e-12));
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
double damper_rate_error(const MethodOnDamper& method, double z) {
    const long double factor = method.factor(z);
    return factor > 0 ? static_cast<double>(std::abs(-std::log(factor) / z - 1))
                      : std::numeric_limits<double>::quiet_NaN();
}

// The end of the stretch of right ch/m. It begins below 2 `wanted`: a method of order one is off by
// z/(2e) there.
double right_damper_step(const MethodOnDamper& method, double wanted) {
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

Advice advise_damper(const MethodOnDamper& method, double rate, double h, double wanted) {
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

}  // namespace

std::vector<Advice> advise_damper(double rate, double h, double wanted) {
    positive("damping over mass", rate);
    positive("step", h);
    if (!(rate * h >= 1e-12 && rate * h <= 1e12))
        refuse("step times damping over mass", rate * h, "from 1e-12 to 1e12");
    if (!(wanted >= 1e-8 && wanted <= 0.5)) refuse("accuracy", wanted, "from 1e-8 to 0.5");
    std::vector<Advice> all;
    for (const auto& method : methods_on_damper()) all.push_back(advise_damper(method, rate, h, wanted));
    return all;
}

Recommendation recommend_damper(double rate, double h, const Goal& goal, const std::vector<Advice>& all) {
    const Choice& row = choice(goal.precise ? "smooth" : rate * h > ended_swing ? "pull" : "swing");
    Recommendation made{&row, place_of_choice(row), 1, row.method, row.take, row.why};
    if (row.name == "swing") {
        made.take = "**semi-implicit Euler**, with the damping at the new velocity";
        made.why = "one division per step, by 1 + hc/m, which no damping makes unstable";
    }
    if (goal.precise) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t place = 0; place < all.size(); ++place) {
            const double step = best_step(all[place], h);
            const long n = step > 0 ? pieces(h, step) : 0;
            if (n == 0 || !(all[place].cost * double(n) < least)) continue;
            least = all[place].cost * double(n), made.substeps = n, made.place = place;
        }
        made.method = all[made.place].method;
        made.take = "**" + made.method + "**",
        made.why = "as accurate as you asked, at the least cost in whole substeps";
        if (std::isinf(least)) made.substeps = 0;
    }
    if (made.substeps == 0) return made;
    const MethodOnDamper method = methods_on_damper()[made.place];
    const double z = rate * h / double(made.substeps);
    made.position_error = damper_error(method, z), made.rate_error = damper_rate_error(method, z);
    return made;
}

}  // namespace timestep
