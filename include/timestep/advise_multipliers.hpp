#pragma once
/// \file
/// What a step multiplies the patterns by that it keeps, and what that says of a spring's
/// frequency, of its decay and of ringing: the numbers behind the command advise (I13).

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <string>
#include <vector>

#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/stability.hpp>

/// \cond
namespace timestep::detail {

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

// A step with ωh = s.
template <class Method>
StepMatrix<long double> matrix_of(const Method& method, long double zeta, long double s) {
    if constexpr (takes_damping<Method>)
        return step_matrix(method, DampedSpring<long double>(1, zeta), s);
    else
        return step_matrix(method, Spring<long double>(1), s);
}
// Plain Verlet, begun by its own start, goes through the positions of velocity Verlet.
inline StepMatrix<long double> matrix_of(const Verlet&, long double zeta, long double s) {
    return matrix_of(velocity_verlet, zeta, s);
}

// Every eigenvalue of a step: what it multiplies the patterns by that it keeps. The first stands
// for the motion: of two decays the slow one, of an oscillation's pair the one that turns forward.
template <class Method>
std::vector<Complex> multipliers(const Method& method, long double zeta, long double s) {
    const auto [a, b] = eigenvalues(matrix_of(method, zeta, s));
    return {a, b};
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
    const long double error =
        std::fmin(std::hypot(frequency, damping), std::abs(a - exact) / std::abs(exact));
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
    const bool one =
        std::any_of(all.begin(), all.end(), [](const Complex& z) { return z.real() >= 0; });
    const std::string by = number(static_cast<double>(-most), 3);
    return std::string("stable, but rings: a step multiplies ") +
           (zeta < 1 ? "the motion"
            : one    ? "the fast part"
                     : "what should decay") +
           " by " + (by == "1" ? "nearly −1" : "−" + by);
}

}  // namespace timestep::detail
/// \endcond
