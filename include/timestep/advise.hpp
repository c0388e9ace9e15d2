#pragma once
/// \file
/// Which method, what does it cost, will my simulation blow up? For one spring with a damper, what
/// every method makes of it at a given step: predicted, without a single step of simulation (I13).

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/stability.hpp>
#include <timestep/stability_limit.hpp>

namespace timestep {

/// Will it blow up?
enum class Verdict {
    stable,             ///< bounded for ever
    grows,              ///< sooner or later it leaves the screen
    too_close_to_call,  ///< within a thousandth of the boundary: no stiffness is known better than
                        ///< that; or the growth is lost in roundoff
    refused             ///< the method cannot step this scene at all
};

/// The verdict in words.
inline const char* words(Verdict verdict) {
    switch (verdict) {
        case Verdict::stable: return "stable";
        case Verdict::grows: return "grows";
        case Verdict::too_close_to_call: return "too close to call";
        default: return "refused";
    }
}

/// Is `value` on the stable side of `limit`?
inline Verdict verdict(double value, double limit) {
    return value < 0.999 * limit   ? Verdict::stable
           : value > 1.001 * limit ? Verdict::grows
                                   : Verdict::too_close_to_call;
}

/// What one method makes of a spring. Numbers that mean nothing here are NaN.
struct Advice {
    std::string method;            ///< its name
    Verdict verdict;               ///< will it blow up?
    std::string reason;            ///< the formula that says so, with its numbers
    double longest_step;           ///< the longest stable step, s; infinite where there is no limit
    double growth_per_step;        ///< what a step multiplies the amplitude by in the long run
    double growth_per_second;      ///< the same for a second of game time
    double energy_ratio;           ///< the energy after a second over what it should be
    double energy_drift;           ///< that minus one
    double period_error;           ///< the period over the exact one, minus one
    double rate_error;             ///< how wrong the motion's frequency and decay are: see advise()
    double cost;                   ///< force evaluations and solves in a second of game time
    double accurate_step = 0;      ///< the end of the first stretch of right steps, s; 0: there is none
    double accurate_cost = 0;      ///< what that costs, evaluations and solves a second; 0 if there is none
    double ringing = 0;            ///< what a step multiplies the part by that rings, below −1/2; 0: none does
    double accurate_from = 0;      ///< where that stretch begins, s: below roundoff is too much
    double step = 0;               ///< the step that was asked about, s
    bool right = false;            ///< is that one stable and as accurate as wanted, and nothing rings?
};

/// \cond
namespace detail {

// Can the method step a force that depends on the velocity?
template <class Method>
inline constexpr bool takes_damping = true;
template <>
inline constexpr bool takes_damping<Verlet> = false;
template <>
inline constexpr bool takes_damping<VelocityVerlet> = false;
template <>
inline constexpr bool takes_damping<Leapfrog> = false;

using Complex = std::complex<long double>;

// μ/ω of the motion e^(μt): −ζ + i √(1 − ζ²), and beyond ζ = 1 the slow one of the two decays.
inline Complex exact_rate(long double zeta) {
    if (zeta < 1) return {-zeta, std::sqrt((1 - zeta) * (1 + zeta))};
    return -1 / (zeta + std::sqrt((zeta - 1) * (zeta + 1)));
}

// Every eigenvalue of a step with ωh = s: what it multiplies the patterns by that it keeps. The
// first stands for the motion: of two decays the slow one, of a swing's pair the one that turns
// forward.
template <class Method>
std::vector<Complex> multipliers(const Method& method, long double zeta, long double s) {
    StepMatrix<long double> matrix{};
    if constexpr (takes_damping<Method>)
        matrix = step_matrix(method, DampedSpring<long double>(1, zeta), s);
    else
        matrix = step_matrix(method, Spring<long double>(1), s);
    const auto [a, b] = eigenvalues(matrix);
    return {a, b};
}
// Plain Verlet goes through the positions of velocity Verlet.
inline std::vector<Complex> multipliers(const Verlet&, long double zeta, long double s) {
    return multipliers(velocity_verlet, zeta, s);
}
// Two steps, so two eigenvalues for each exponent z of the motion: (3 − 2z) λ² − 4λ + 1 = 0.
inline std::vector<Complex> multipliers(const Bdf2&, long double zeta, long double s) {
    std::vector<Complex> all;
    const Complex rate = exact_rate(zeta);
    for (const Complex& z : {s * rate, s / rate})  // the product of the two rates is ω²
        for (const Complex& r : {std::sqrt(1.0L + 2.0L * z), -std::sqrt(1.0L + 2.0L * z)})
            all.push_back(1.0L / (2.0L - r));  // (2 + r)/(3 − 2z) = 1/(2 − r), as r² = 1 + 2z
    return all;
}

// A method on one spring, and its type forgotten: what is said of it is compiled once for all of them.
struct Judged {
    const char* name;
    int work;  // evaluations and solves in a step
    bool takes_damping;
    StabilityLimit limit;
    std::function<std::vector<Complex>(long double s)> multipliers;
};
template <class Method>
Judged judged(const Method& method, double zeta) {
    return {method.name, method.cost.evaluations + method.cost.solves, takes_damping<Method>,
            stability_limit(method, zeta),
            [=](long double s) { return multipliers(method, zeta, s); }};
}

// How wrong the motion is: its exponent ln λ / h, or the spring that has both such exponents. Of that
// spring their sum is −2ζ'ω' and their product ω'², and it is as wrong as ω' and ζ'ω' are. Near ζ = 1,
// where the two exponents meet, they are split by the root of any change of the spring: so one exponent
// says too much there, and far beyond, where the fast one is soon over, the spring does. The smaller
// counts. What a step changes is rounded, in double: where it is a small share of the state, as in a
// slow decay at a short step, up to 2⁻⁵³ over that share is lost, and at last the whole.
constexpr long double rounded = 0x1p-53L;

inline double rate_error(const Judged& method, long double zeta, long double s) {
    const auto all = method.multipliers(s);  // BDF2's come in pairs
    const Complex a = std::log(all.front()) / s, b = std::log(all[all.size() / 2]) / s;
    const long double frequency = std::abs(std::sqrt(a * b) - 1.0L);
    const long double damping = std::abs(a + b + 2 * zeta) / (2 * std::max(zeta, 1.0L));
    const Complex exact = exact_rate(zeta);
    const long double error =
        std::fmin(std::hypot(frequency, damping), std::abs(a - exact) / std::abs(exact));
    return static_cast<double>(std::fmax(error, std::fmin(1.0L, rounded / (s * std::abs(exact)))));
}

inline std::string number(double value, int digits = 4) {
    char text[32];
    const bool plain = std::abs(value) >= 1000 && std::abs(value) < 999999.5 && digits < 7;
    if (plain)
        std::snprintf(text, sizeof text, "%.0f", value);
    else
        std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

// What rings: a part that a step turns about and keeps a good deal of. It shakes from frame to frame,
// which no spring does, and the rate of the slow part knows nothing of it. The bound is −1/2: there seven
// steps leave 1 % of it, which at 60 Hz is over in a ninth of a second and hardly seen. Farther down it
// soon takes seconds.
constexpr long double rings_below = -0.5L;

// The most negative multiplier that rings; 0 where none does. A real one has no swing to follow. A complex
// one stands for a swing, which turns its sign by itself: it rings where the true motion keeps less than
// half as much of it (there ζ < 1, and the true one keeps e^(−ζs) a step).
inline long double ringing(const std::vector<Complex>& all, long double zeta, long double s) {
    long double most = 0;
    for (const Complex& each : all) {
        const bool no_swing = each.imag() == 0 || 2 * std::exp(-zeta * s) < std::abs(each);
        if (no_swing && each.real() < rings_below) most = std::min(most, each.real());
    }
    return most;
}

// Where it rings, in words. Of two decays with multipliers of different signs the fast one is below zero.
inline std::string ringing_words(const std::vector<Complex>& all, long double most, double zeta) {
    const bool one = std::any_of(all.begin(), all.end(), [](const Complex& z) { return z.real() >= 0; });
    const std::string by = number(static_cast<double>(-most), 3);
    return std::string("stable, but rings: a step multiplies ") +
           (zeta < 1 ? "the motion" : one ? "the fast part" : "what should decay") + " by " +
           (by == "1" ? "nearly −1" : "−" + by);
}

// Is a step with ωh = s stable, as accurate as wanted, and free of ringing?
inline bool is_right(const Judged& method, double zeta, double s, double wanted) {
    return verdict(s, method.limit.value) == Verdict::stable &&
           rate_error(method, zeta, s) <= wanted && ringing(method.multipliers(s), zeta, s) == 0;
}

// The first stretch of s = ωh that are right; zeros where none is.
struct Stretch {
    double from = 0, to = 0;
};

// The error first rises from zero, but it need not go on rising: at longer steps errors of frequency
// and damping may come to cancel. Those steps are not searched for. We begin where roundoff alone is
// as much as wanted; a coarse way up finds an s that is no longer right, and bisection the place.
inline Stretch first_right(const Judged& method, double zeta, double wanted) {
    const auto good = [&](double s) { return is_right(method, zeta, s, wanted); };
    const double end = std::min(method.limit.value, 100 * (1 + zeta));  // by then the slow decay is over in a step
    double from = 1.0001 * static_cast<double>(rounded / (wanted * std::abs(exact_rate(zeta))));
    while (from < end && !good(from)) from *= 1.05;
    if (!(from < end)) return {};
    const double small = wanted / (10 + 20 * zeta);  // up to here the error rises
    double low = good(small) ? small : from, high = low;
    while (good(high)) low = high, high *= 1.05;
    for (int i = 0; i < 40; ++i) {
        const double middle = low + (high - low) / 2;
        (good(middle) ? low : high) = middle;
    }
    return {from, low};
}

// Why it is stable or not, for people.
inline std::string reason(const StabilityLimit& limit, double s) {
    if (!std::isfinite(limit.value)) return "stable for every step";
    const int digits = number(s) == number(limit.value) ? 7 : 4;  // as many as tell the two apart
    const std::string left = number(s, digits), right = number(limit.value, digits);
    const std::string words = limit.formula, link = words.starts_with("the ") ? ", " : " = ";
    const std::string formula = right == words ? "" : link + words;
    if (left == right) return "ωh = " + left + formula + ", the limit itself";
    return "ωh = " + left + (s < limit.value ? " < " : " > ") + right + formula;
}

inline Advice advise(const Judged& method, const DampedSpring<double>& spring, double h,
                     double wanted) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (!method.takes_damping && spring.zeta > 0)
        return {method.name, Verdict::refused, "takes forces of the position only",
                nan, nan, nan, nan, nan, nan, nan, nan};

    const double s = spring.omega * h, zeta = spring.zeta;
    const StabilityLimit& limit = method.limit;
    const auto all = method.multipliers(s);
    const Complex lambda = all.front(), exact = exact_rate(zeta);
    long double largest = 0;
    for (const Complex& each : all) largest = std::max(largest, std::abs(each));

    Advice advice;
    advice.method = method.name;
    advice.verdict = verdict(s, limit.value);
    advice.reason = reason(limit, s);
    if (advice.verdict == Verdict::stable) {
        const long double most = ringing(all, zeta, s);
        advice.ringing = static_cast<double>(most);
        if (most < 0) {
            const std::string why = ringing_words(all, most, zeta);
            advice.reason = std::isfinite(limit.value) ? why + "; " + advice.reason : why;
        }
    }
    advice.longest_step = limit.value / spring.omega;
    advice.growth_per_step = static_cast<double>(largest);
    advice.growth_per_second = static_cast<double>(std::exp(std::log(largest) / h));
    const long double energy_rate = 2 * (std::log(largest) - exact.real() * s) / h;
    advice.energy_ratio = static_cast<double>(std::exp(energy_rate));
    advice.energy_drift = static_cast<double>(std::expm1(energy_rate));
    advice.period_error = exact.imag() > 0 && lambda.imag() > 0
                              ? static_cast<double>(exact.imag() * s / std::arg(lambda) - 1)
                              : nan;
    advice.rate_error = rate_error(method, zeta, s);
    advice.cost = method.work / h;
    advice.step = h;
    advice.right = is_right(method, zeta, s, wanted);
    if (const Stretch stretch = first_right(method, zeta, wanted); stretch.to > 0) {
        advice.accurate_from = stretch.from / spring.omega;
        advice.accurate_step = stretch.to / spring.omega;
        advice.accurate_cost = method.work / advice.accurate_step;
    }
    return advice;
}
template <class Method>
Advice advise(const Method& method, const DampedSpring<double>& spring, double h, double wanted) {
    return advise(judged(method, spring.zeta), spring, h, wanted);
}

}  // namespace detail
/// \endcond

/// What every method of the course makes of `spring` at steps of `h` seconds, in the order in which the
/// course meets them.
///
/// Growth, period and energy are those of the step's eigenvalues. Of the motion e^(μt) a step makes
/// e^((ln λ / h) t), so |ln λ / h − μ| / |μ| is how wrong its rate is, frequency and decay together: 1 %
/// turns a swing into one whose period, or whose loss per radian, is off by 1 %. Near ζ = 1 the two
/// rates of a spring meet, and tiny changes of it drive them far apart. There the step's motion is
/// compared as a whole: it is that of another spring, ω' and ζ', and the error is |ω' − ω|/ω and
/// |ζ'ω' − ζω|/ω together (beyond ζ = 1 the latter is |ζ'ω' − ζω|/(ζω)). The smaller of the two errors
/// counts. (The positions of semi-implicit Euler lie on a swing of the right size; its velocities, half a
/// step early, are not judged.) Roundoff counts too: in double, a step that changes the state only by
/// a share δ is off by up to 2⁻⁵³/δ.
///
/// `wanted` is how large the error may be. A step is **right** if it is stable, the error is no
/// larger, and nothing rings. Told are whether the step `h` is, and the end of the first stretch of
/// right steps. Longer ones may be right again, by errors that happen to cancel; of those only `h`
/// itself is looked at.
///
/// A stable method may still **ring**: a step multiplies a part that should decay by less than −1/2, and it
/// shakes from step to step. Then the advice says so.
///
/// A force evaluation and a solve are counted as equally dear. Throws `std::invalid_argument` where
/// ω or h is not above zero and finite, where ωh is below 1e-12 (a step then changes nothing but the last
/// digits) or not finite, or `wanted` is not between 1e-8 and 0.5.
inline std::vector<Advice> advise(const DampedSpring<double>& spring, double h, double wanted = 0.01) {
    positive("omega", spring.omega);
    positive("step", h);
    if (!std::isfinite(spring.omega * h)) refuse("step", h, "so short that omega times it is finite");
    if (spring.omega * h < 1e-12) refuse("step", h, "so long that omega times it is 1e-12 or more");
    if (!(wanted >= 1e-8 && wanted <= 0.5)) refuse("accuracy", wanted, "from 1e-8 to 0.5");
    std::vector<Advice> all;
    const auto add = [&](const auto& method) {
        all.push_back(detail::advise(method, spring, h, wanted));
    };
    for_each_method(add);
    add(semi_implicit_euler_new_damping);
    for_each_verlet_method(add);
    return all;
}

/// The longest step known to be right and no longer than `longest`, in seconds; 0 if there is none.
inline double best_step(const Advice& advice,
                        double longest = std::numeric_limits<double>::infinity()) {
    const double best =
        advice.accurate_from <= longest ? std::min(advice.accurate_step, longest) : 0;
    return advice.right && advice.step <= longest ? std::max(best, advice.step) : best;
}

/// What the method costs a second at best_step().
inline double best_cost(const Advice& advice,
                        double longest = std::numeric_limits<double>::infinity()) {
    const double step = best_step(advice, longest);
    return step > 0 ? advice.cost * (advice.step / step) : 0;
}

/// Of the methods that reach the wanted accuracy the one that does so at the least cost, with steps no
/// longer than `longest`; of equally dear ones the one with the smaller error. Null where none does.
inline const Advice* cheapest(const std::vector<Advice>& all,
                              double longest = std::numeric_limits<double>::infinity()) {
    const Advice* best = nullptr;
    for (const Advice& advice : all) {
        if (!(best_step(advice, longest) > 0)) continue;
        const double ratio = best ? best_cost(advice, longest) / best_cost(*best, longest) : 0;
        const bool alike = std::abs(ratio - 1) < 1e-9;
        if (alike ? advice.rate_error < best->rate_error : ratio < 1) best = &advice;
    }
    return best;
}

}  // namespace timestep
