#pragma once
/// \file
/// The stability function R(z) of every method that has one: the factor by which a step multiplies
/// a decay (N60, N62).
///
/// On ẏ = λ y a step of length h is a multiplication, y₂ = R(z) y₁, which depends only on the
/// complex number z = hλ. The exact motion multiplies by e^z. A linear scene is a sum of such
/// motions, so the method is stable on it where |R(z)| ≤ 1 for the z of each.
///
/// Semi-implicit Euler and the methods of Verlet's kind have no R: they treat position and velocity
/// differently, and a first-order system does not say which is which. For them see stability.hpp.

#include <complex>

#include <timestep/methods/bdf2.hpp>
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/heun.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/implicit_midpoint.hpp>
#include <timestep/methods/midpoint.hpp>
#include <timestep/methods/runge_kutta_4.hpp>

namespace timestep {

/// A complex number: z = hλ, or R(z).
using Complex = std::complex<double>;

/// Explicit Euler, y₂ = y₁ + h λ y₁: the series of e^z as far as z.
inline Complex stability_function(const ExplicitEuler&, Complex z) { return 1.0 + z; }

/// Midpoint, y₂ = y₁ + z (y₁ + z/2 y₁): as far as z².
inline Complex stability_function(const Midpoint&, Complex z) { return 1.0 + z + z * z / 2.0; }

/// Heun, y₂ = y₁ + z/2 (y₁ + (1 + z) y₁): on a linear scene the midpoint method by another way.
inline Complex stability_function(const Heun&, Complex z) { return 1.0 + z + z * z / 2.0; }

// Factored, as z³ and z⁴ may both be infinite, with opposite signs.
/// RK4: as far as z⁴, 1 + z + z²/2 + z³/6 + z⁴/24.
/// [four stages]
inline Complex stability_function(const RungeKutta4&, Complex z) {
    return 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
}
/// [four stages]

/// Implicit Euler, y₂ = y₁ + z y₂.
inline Complex stability_function(const ImplicitEuler&, Complex z) { return 1.0 / (1.0 - z); }

/// Implicit midpoint, y₂ = y₁ + z (y₁ + y₂)/2.
/// [implicit midpoint]
inline Complex stability_function(const ImplicitMidpoint&, Complex z) {
    return (1.0 + z / 2.0) / (1.0 - z / 2.0);
}
/// [implicit midpoint]

// 3y₂ − 4y₁ + y₀ = 2z y₂ is solved by yₙ = Rⁿ where (3 − 2z) R² − 4R + 1 = 0. The roots are
// (2 ± w)/(3 − 2z) with w = √(1 + 2z); and 3 − 2z = 4 − w² = (2 + w)(2 − w).
/// BDF2, over two steps: there are two factors, and this is the larger one, which is left in the
/// long run.
/// [bdf2]
inline Complex stability_function(const Bdf2&, Complex z) {
    return 1.0 / (2.0 - std::sqrt(1.0 + 2.0 * z));
}
/// [bdf2]

/// Whether the method has a stability function.
template <class Method>
concept HasStabilityFunction = requires(const Method& m, Complex z) {
    stability_function(m, z);
};

/// Calls `visit(method)` for each method that has one: the explicit methods, then the implicit
/// ones.
template <class Visit>
void for_each_stability_function(const Visit& visit) {
    visit(explicit_euler), visit(midpoint), visit(heun), visit(runge_kutta_4);
    visit(implicit_euler), visit(implicit_midpoint), visit(bdf2);
}

}  // namespace timestep
