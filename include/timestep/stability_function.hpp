#pragma once
/// \file
/// The stability function R(z) of a method: what a step multiplies e^(λt) by, where z = hλ.
///
/// Every linear scene is a sum of motions e^(λt), each with a complex rate λ of its own: Re λ < 0 decays,
/// and Im λ swings. On ẏ = λy a step of a method becomes y₂ = R(hλ) y₁. The motion itself is multiplied by
/// e^z, and R is the method's stand-in for it. Where |R(z)| ≤ 1 the method is stable (N62).
///
/// Methods that treat position and velocity in different ways (semi-implicit Euler, Verlet) have none: they
/// are no methods for ẏ = λy. Their step is a matrix; see stability.hpp.

#include <complex>

#include <timestep/methods.hpp>

namespace timestep {

/// [functions]
/// y₂ = y₁ + z y₁
template <class Real>
std::complex<Real> stability_function(const ExplicitEuler&, std::complex<Real> z) {
    return Real(1) + z;
}
/// y₂ = y₁ + z y₂
template <class Real>
std::complex<Real> stability_function(const ImplicitEuler&, std::complex<Real> z) {
    return Real(1) / (Real(1) - z);
}
/// y₂ = y₁ + z (y₁ + y₂)/2
template <class Real>
std::complex<Real> stability_function(const ImplicitMidpoint&, std::complex<Real> z) {
    return (Real(1) + z / Real(2)) / (Real(1) - z / Real(2));
}
/// y₂ = y₁ + z (y₁ + z/2 y₁): the Taylor series of e^z up to z²
template <class Real>
std::complex<Real> stability_function(const Midpoint&, std::complex<Real> z) {
    return Real(1) + z * (Real(1) + z / Real(2));
}
/// Two stages of order two: the same as midpoint.
template <class Real>
std::complex<Real> stability_function(const Heun&, std::complex<Real> z) {
    return stability_function(midpoint, z);
}
/// Four stages of order four: the Taylor series up to z⁴/24
template <class Real>
std::complex<Real> stability_function(const RungeKutta4&, std::complex<Real> z) {
    return Real(1) + z * (Real(1) + z / Real(2) * (Real(1) + z / Real(3) * (Real(1) + z / Real(4))));
}
/// [functions]

// BDF2 steps from two states: 3y₂ − 4y₁ + y₀ = 2z y₂. A motion that is multiplied by r each step has
// (3 − 2z) r² − 4r + 1 = 0, and so r = (2 ± √(1 + 2z))/(3 − 2z) = 1/(2 ∓ √(1 + 2z)).
/// BDF2: the root that is near e^z for small z. The other one is the smaller of the two wherever
/// Re √(1 + 2z) > 0, which is everywhere.
template <class Real>
std::complex<Real> stability_function(const Bdf2&, std::complex<Real> z) {
    return Real(1) / (Real(2) - std::sqrt(Real(1) + Real(2) * z));
}

}  // namespace timestep
