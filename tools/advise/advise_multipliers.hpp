#pragma once
/// \file
/// What a step multiplies the patterns by that it keeps, and what that says of a spring's
/// frequency, of its decay and of ringing: the numbers behind the command advise (I13).

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <timestep/multipliers.hpp>

/// \cond
namespace timestep::detail {

// What a step changes is rounded, in double: where it is a small share of the state, as in a slow
// decay at a short step, up to 2⁻⁵³ over that share is lost, and at last the whole.
constexpr long double rounded = 0x1p-53L;

inline long double roundoff(long double zeta, long double s) {
    return std::fmin(1.0L, rounded / (s * std::abs(exact_rate(zeta))));
}

// How wrong frequency and decay are: the motion's exponent ln λ / h, or the spring that has both
// such exponents. Of that spring their sum is −2ζ'ω' and their product ω'², and it is as wrong as
// ω' and ζ'ω' are. Near ζ = 1, where the two exponents meet, they are split by the root of any
// change of the spring: so one exponent says too much there, and far beyond, where the fast one is
// soon over, the spring does. The smaller counts.
inline double rate_error(const std::vector<Complex>& all, long double zeta, long double s) {
    const Complex a = std::log(all.front()) / s,
                  b = std::log(all[all.size() / 2]) / s;  // BDF2's come in pairs
    const long double frequency = std::abs(std::sqrt(a * b) - 1.0L);
    const long double damping = std::abs(a + b + 2 * zeta) / (2 * std::max(zeta, 1.0L));
    const Complex exact = exact_rate(zeta);
    const long double error = std::fmin(std::hypot(frequency, damping), std::abs(a - exact) / std::abs(exact));
    return static_cast<double>(std::fmax(error, roundoff(zeta, s)));
}

// A number for people.
inline std::string number(double value, int digits = 4) {
    char text[32];
    const bool plain = std::abs(value) >= 1000 && std::abs(value) < 999999.5 && digits < 7;
    if (plain)
        std::snprintf(text, sizeof text, "%.0f", value);
    else
        std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

// What rings: a part that a step turns about and keeps a good deal of. It shakes from frame to
// frame, which no spring does, and the rate of the slow part knows nothing of it. The bound is
// −1/2: there seven steps leave 1 % of it, which at 60 Hz is over in a ninth of a second and hardly
// seen. Farther down it soon takes seconds.
constexpr long double rings_below = -0.5L;

// The most negative multiplier that rings; 0 where none does. A real one has no oscillation to
// follow. A complex one stands for an oscillation, which turns its sign by itself: it rings where
// the true motion keeps less than half as much of it (there ζ < 1, and the true one keeps e^(−ζs) a
// step).
inline long double ringing(const std::vector<Complex>& all, long double zeta, long double s) {
    long double most = 0;
    for (const Complex& each : all) {
        const bool no_swing = each.imag() == 0 || 2 * std::exp(-zeta * s) < std::abs(each);
        if (no_swing && each.real() < rings_below) most = std::min(most, each.real());
    }
    return most;
}

// Where it rings, in words. Of two decays with multipliers of different signs the fast one is below
// zero.
inline std::string ringing_words(const std::vector<Complex>& all, long double most, double zeta) {
    const bool one = std::any_of(all.begin(), all.end(), [](const Complex& z) { return z.real() >= 0; });
    const std::string by = number(static_cast<double>(-most), 3);
    return std::string("stable, but rings: a step multiplies ") +
           (zeta < 1 ? "the motion"
            : one    ? "the fast part"
                     : "what should decay") +
           " by " + (by == "1" ? "nearly −1" : "−" + by);
}

}  // namespace timestep::detail
/// \endcond
