#pragma once
/// \file
/// The multipliers of a step: every eigenvalue of a method's step on a damped spring (N23).

#include <cmath>
#include <complex>
#include <vector>

#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/stability.hpp>

/// \cond
namespace timestep::detail {

using Complex = std::complex<long double>;

// μ/ω of the motion e^(μt): −ζ + i √(1 − ζ²), and beyond ζ = 1 the slow one of the two decays.
inline Complex exact_rate(long double zeta) {
    if (zeta < 1) return {-zeta, std::sqrt((1 - zeta) * (1 + zeta))};
    return -1 / (zeta + std::sqrt((zeta - 1) * (zeta + 1)));
}

// A step with ωh = s.
template <class Method>
StepMatrix<long double> matrix_of(const Method& method, long double zeta, long double s) {
    if constexpr (Method::takes_damping)
        return step_matrix(method, DampedSpring<long double>(1, zeta), s);
    else
        return step_matrix(method, Spring<long double>(1), s);
}
// Plain Verlet, begun by its own start, goes through the positions of velocity Verlet.
inline StepMatrix<long double> matrix_of(const Verlet&, long double zeta, long double s) {
    return matrix_of(velocity_verlet, zeta, s);
}

// The first multiplier stands for the motion: of two decays the slow one, of an oscillation's pair
// the one that turns forward.
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

}  // namespace timestep::detail
/// \endcond
