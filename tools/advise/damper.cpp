// A damper and nothing else: what every method makes of a velocity that decays at the rate c/m.

#include <algorithm>
#include <cmath>
#include <limits>

#include <timestep/checks.hpp>

#include "method_on_spring.hpp"
#include "words.hpp"

#if defined(__clang__)  // what is long double here is meant to be
#pragma clang diagnostic ignored "-Wdouble-promotion"
#endif

namespace timestep {

namespace {

// A damper alone is the fast decay of a spring that hardly pulls: in units of that spring, hc/m is 2ζ ωh.
constexpr double hard = 1e100;

double limit_of(const MethodOnSpring& method) {  // of hc/m
    const double limit = method.limit.value * 2 * hard;
    return limit < 1e9 ? limit : std::numeric_limits<double>::infinity();
}

// What a step multiplies the velocity by in the long run; the spring's own multiplier is 1. Of BDF2's two factors the
// larger; where they are a pair, the size of both.
long double factor_of(const MethodOnSpring& method, double z) {
    const std::vector<Complex> all = method.multipliers(z / (2 * static_cast<long double>(hard)));
    if (all.size() == 2) return std::abs(all[0]) > 2 ? all[0].real() : (all[0] * all[1]).real();
    return all[2].imag() == 0 ? std::max(all[2].real(), all[3].real()) : std::abs(all[2]);
}

double error_of(const MethodOnSpring& method, double z) {
    return std::max(static_cast<double>(rounded) / z, method.velocity_error(z / (2 * static_cast<long double>(hard))));
}

// How wrong the rate of the decay is; NaN where the velocity turns its sign.
double rate_error_of(const MethodOnSpring& method, double z) {
    const long double factor = factor_of(method, z);
    return factor > 0 ? static_cast<double>(std::abs(-std::log(factor) / z - 1)) : Advice::unknown;
}

// The end of the stretch of right hc/m. It begins below 2 `wanted`: a method of order one is off by
// z/(2e) there.
double right_end(const MethodOnSpring& method, double wanted) {
    const auto good = [&](double z) {
        return verdict(z, limit_of(method)) == Verdict::stable && factor_of(method, z) >= rings_below &&
               error_of(method, z) <= wanted;
    };
    double low = wanted, high = 2 * wanted;
    while (high < 1e3 && good(high)) low = high, high *= 1.05;
    return last_good(good, low, high);
}

Advice advise_damper(const MethodOnSpring& method, double rate, double h, double wanted) {
    if (!method.takes_damping) return refused(method);
    const double z = rate * h, limit = limit_of(method);
    const long double factor = factor_of(method, z), size = std::abs(factor);
    Advice advice;
    advice.method = method.name;
    advice.verdict = verdict(z, limit);
    advice.reason = limit_reason("hc/m", z, {limit, ""});
    advice.longest_step = limit / rate;
    tell_growth(advice, std::log(size), h, -rate);
    advice.position_error = error_of(method, z);
    advice.rate_error = rate_error_of(method, z);
    advice.cost = method.work / h, advice.step = h;
    if (advice.verdict == Verdict::stable && factor < rings_below) {
        advice.ringing = static_cast<double>(factor);
        advice.reason = phrase(
            "why.rings", {{"part", phrase("why.velocity")}, {"factor", "−" + number(static_cast<double>(size), 3)}});
    }
    advice.right = advice.verdict == Verdict::stable && advice.ringing == 0 && advice.position_error <= wanted;
    advice.accurate_from = static_cast<double>(rounded) / wanted / rate;
    advice.accurate_step = right_end(method, wanted) / rate;
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
    for (const auto& method : methods_on_spring(hard, hard)) all.push_back(advise_damper(method, rate, h, wanted));
    return all;
}

Recommendation recommend_damper(double rate, double h, const Goal& goal, const std::vector<Advice>& all) {
    const Choice& row = choice(goal.precise ? "smooth" : rate * h > ended_swing ? "pull" : "swing");
    Recommendation made{&row, place_of_choice(row), 1, row.method, row.take, row.why};
    if (row.name == "swing") made.take = phrase("recommend.new_damping"), made.why = phrase("recommend.damper_divides");
    if (goal.precise) {
        Right best{made.place};
        for (std::size_t place = 0; place < all.size(); ++place)
            if (const Right right = right_steps(all, place, h); right.cost < best.cost) best = right;
        made.place = best.place, made.substeps = best.substeps, made.method = all[best.place].method;
        made.take = "**" + made.method + "**", made.why = phrase("recommend.accurate");
    }
    if (made.substeps == 0) return made;
    const MethodOnSpring method = methods_on_spring(hard, hard)[made.place];
    const double z = rate * h / double(made.substeps);
    made.position_error = error_of(method, z), made.rate_error = rate_error_of(method, z);
    return made;
}

}  // namespace timestep
