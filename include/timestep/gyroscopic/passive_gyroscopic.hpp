#pragma once
/// \file
/// A gyroscopic step that never adds energy, for engines in which a rule can act only before the
/// contacts.

#include <timestep/inline.hpp>
#include <timestep/rigid/symmetric_about.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// The passive step, linearly implicit. It uses the angular momentum L of the old state and the
/// angular velocity of the new one, I(ω₂ − ω₁) = h L₁ × ω₂ (as the engine ODE does), so that the
/// equation is linear and the torque does no work. The solution is explicit Euler's with one more
/// term, divided by a number: a few lines without a branch or a determinant that could vanish.
///
/// Order one, like the talk's solver. The energy never grows, for any inertia, spin and step (N51).
/// The angular momentum is kept to order one only, and never shrinks. So a free body ends up
/// spinning about the axis of its largest moment, however short the step. If two moments are equal,
/// use SymmetricInertia, whose step loses nothing. This holds up to hω = 1e140, in `float` 1e12,
/// for moments up to 1e12 to 1. If (hω)² is too large for a number (hω beyond 1e154, in `float`
/// 1e19, less by the root of the moments' ratio), three moments return NaN.
struct PassiveGyroscopic : InOtherAxes<PassiveGyroscopic> {
    static constexpr const char* name = "passive";  ///< for tables and keys
    static constexpr int order = 1;                 ///< of the error after a whole run
    using InOtherAxes<PassiveGyroscopic>::step;

    // In s = √I ω the energy is ½|s|², and with k_x = h L_x/√(I_y I_z) and so on round the equation
    // is
    //     s₂ − k × s₂ = s₁.
    // No energy is added: k × s₂ is at right angles to s₂, so |s₁|² = |s₂|² + |k × s₂|².
    // Solved, by a dot and a cross product with k: s₂ = (s₁ + k × s₁ + (k·s₁) k) / (1 + k·k). Back
    // in ω, with the moments U whose product is one, l = h U ω₁, and a_x = h (I_z − I_y)/I_x, that
    // is
    //     ω₂ = (ω₁ − p + (l·l) U ω₁) / (1 + l·U l)  with ω₁ = (x, y, z), p = (a_x yz, a_y zx, a_z
    //     xy).
    // Dividing first keeps products from overflowing.
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    /// [step]
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        const Vector3<Real>& U = inertia.unit;
        const Vector3<Real> a = h * inertia.ratio;
        const Vector3<Real> l = h * U.cwiseProduct(omega);
        const Real x = omega.x(), y = omega.y(), z = omega.z();
        const Real share =
            1 / (1 + (U.x() * l.x() * l.x() + U.y() * l.y() * l.y() + U.z() * l.z() * l.z()));
        const Real l_l = dot(l, l);
        return Vector3<Real>(share * x - a.x() * y * (share * z) + l_l * U.x() * (share * x),
                             share * y - a.y() * z * (share * x) + l_l * U.y() * (share * y),
                             share * z - a.z() * x * (share * y) + l_l * U.z() * (share * z));
    }
    /// [step]

    // A symmetric body's ω rotates about its axis by the angle θ = h (along − across)/across ω_z:
    // that is the exact motion. A rotation is three shears, with t = tan(θ/2) and s = sin θ. A
    // shear by a rounded t is still a shear and changes no area. A rounded cosine and sine make a
    // rotation that grows or shrinks a little, in the same direction in every step: in `float` by
    // up to three percent per hour. No tangent is needed: with u = θ/2, u/(1 − u²/3 + u⁴/9) is so
    // near that the angle is off by θ⁵/120, and for fast spins, where it is far from the tangent,
    // the step is still a rotation.
    /// One step of `h` seconds of a body with two equal moments, which keeps energy and |L|;
    /// `omega` in body coordinates, rad/s.
    /// [symmetric]
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const SymmetricInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        const Real u = h / 2 * inertia.precession_ratio * omega.z();  // θ/2
        const Real p = u * u / 3;
        const Real t = u / (1 - p + p * p);
        const Real s = 2 * t / (1 + t * t);
        const Real x = omega.x() - t * omega.y();
        const Real y = omega.y() + s * x;
        return {x - t * y, y, omega.z()};
    }
    /// [symmetric]
};

inline constexpr PassiveGyroscopic passive_gyroscopic;  ///< the method as a value

// The half-step Jacobian's own equations for two equal moments rotate ω by 2 atan(θ/2), where the
// exact motion rotates it by θ. Up to three radians the passive step is nearer to that.
/// The steps of InOtherAxes, and for two equal moments the passive step, which keeps energy and |L|
/// there.
template <class Solver>
struct PassiveIfSymmetric : InOtherAxes<Solver> {
    using InOtherAxes<Solver>::step;
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const SymmetricInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        return passive_gyroscopic.step(inertia, omega, h);
    }
};

}  // namespace timestep
