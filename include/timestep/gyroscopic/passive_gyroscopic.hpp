#pragma once
/// \file
/// A gyroscopic step that never adds energy: for engines where a rule can only act before the
/// contacts.

#include <timestep/inline.hpp>
#include <timestep/rigid/symmetric_about.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// The passive step, linearly implicit. It takes the angular momentum L from the old state and the
/// angular velocity from the new one, I(ω₂ − ω₁) = h L₁ × ω₂ (as the engine ODE does), so that the
/// equation is linear and the torque does no work. Its solution is explicit Euler's, and a little
/// more, over a number: a few lines without a branch, and without a determinant that could vanish.
///
/// Order one, as the talk's solver; the energy never grows, for any inertia, spin and step (N51).
/// The angular momentum is kept to order one only: it never shrinks. So a body left alone ends
/// turning about its largest principal moment, however short the step; where two moments are equal,
/// say so by SymmetricInertia, whose step loses nothing. All this up to hω = 1e140, in float 1e12,
/// for moments up to 1e12 to 1. Where (hω)² is too large for a number (hω beyond 1e154, in float
/// 1e19, less by the root of the moments' ratio) three moments give back NaN.
struct PassiveGyroscopic {
    static constexpr const char* name = "passive";  ///< for tables and keys
    static constexpr int order = 1;                 ///< of the error after a whole run

    // In s = √I ω the energy is ½|s|², and with k_x = h L_x/√(I_y I_z) and so on round the equation
    // is
    //     s₂ − k × s₂ = s₁.
    // No energy is added: k × s₂ is at right angles to s₂, so |s₁|² = |s₂|² + |k × s₂|².
    // Solved, by a dot and a cross product with k: s₂ = (s₁ + k × s₁ + (k·s₁) k) / (1 + k·k). Back
    // in ω, with the moments U whose product is one, l = h U ω₁, and a_x = h (I_z − I_y)/I_x, that
    // is
    //     ω₂ = (ω₁ − p + (l·l) U ω₁) / (1 + l·U l)  with ω₁ = (x, y, z), p = (a_x yz, a_y zx, a_z
    //     xy).
    // We divide first, so that no product overflows that the division would tame.
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    /// [step]
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                                       const Vector3<Real>& omega, Real h) const noexcept {
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

    // A symmetric body's ω turns about its axis by the angle θ = h (along − across)/across ω_z:
    // that is the exact motion. A turn is three shears, with t = tan(θ/2) and s = sin θ. A shear by
    // a rounded t is a shear all the same and changes no area; a rounded cosine and sine make a
    // turn that grows or shrinks a little, the same way in every step: in float by up to three
    // percent in an hour. And no tangent is needed: with u = θ/2, u/(1 − u²/3 + u⁴/9) is near
    // enough that the angle is off by θ⁵/120, and for fast spins, where it is far from the tangent,
    // it still makes a turn.
    /// The same where two moments are equal: nothing is lost either.
    /// [symmetric]
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const SymmetricInertia<Real>& inertia,
                                       const Vector3<Real>& omega, Real h) const noexcept {
        const Real u = h / 2 * inertia.precession_ratio * omega.z();  // θ/2
        const Real p = u * u / 3;
        const Real t = u / (1 - p + p * p);
        const Real s = 2 * t / (1 + t * t);
        const Real x = omega.x() - t * omega.y();
        const Real y = omega.y() + s * x;
        return {x - t * y, y, omega.z()};
    }
    /// [symmetric]

    /// The same with another odd axis.
    template <Axis axis, class Real>
    TIMESTEP_INLINE Vector3<Real> step(const SymmetricAbout<axis, Real>& inertia,
                                       const Vector3<Real>& omega, Real h) const noexcept {
        return inertia.from_z(step(inertia.about_z, inertia.to_z(omega), h));
    }

    /// The same in any axes: there and back by way of the principal ones.
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const FullInertia<Real>& inertia, const Vector3<Real>& omega,
                                       Real h) const noexcept {
        const Vector3<Real> turned = in_body(inertia.axes, omega);
        return in_world(inertia.axes, step(inertia.principal, turned, h));
    }
};

inline constexpr PassiveGyroscopic passive_gyroscopic;  ///< the method as a value

}  // namespace timestep
