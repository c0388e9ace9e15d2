#pragma once
/// \file
/// A gyroscopic step that never adds energy: the default for games.

#include <timestep/inline.hpp>
#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// The passive step. It takes the angular momentum L from the old state and the angular velocity
/// from the new one, I(ω₂ − ω₁) = h L₁ × ω₂ (as the engine ODE does), so that the equation is linear
/// and the torque does no work. Its solution is explicit Euler's, and a little more, over a number: a
/// few lines without a branch, and without a determinant that could vanish.
///
/// Order one, as the talk's solver; the energy never grows, for any inertia, spin and step (N51). The
/// angular momentum is kept to order one only: it never shrinks. So a body left alone ends turning about
/// its largest moment, however short the step; where two moments are equal, say so by SymmetricInertia,
/// whose step loses nothing. Where (hω)² is too large for a number (hω beyond 1e154, in float 1e19,
/// less by the root of the moments' ratio) three moments give back NaN.
struct PassiveGyroscopic {
    static constexpr const char* name = "passive";  ///< for tables and keys
    static constexpr int order = 1;                 ///< of the error after a whole run

    // In s = √I ω the energy is ½|s|², and with k_x = h L_x/√(I_y I_z) and so on round the equation is
    //     s₂ − k × s₂ = s₁.
    // No energy is added: k × s₂ is at right angles to s₂, so |s₁|² = |s₂|² + |k × s₂|².
    // Solved, by a dot and a cross product with k: s₂ = (s₁ + k × s₁ + (k·s₁) k) / (1 + k·k). Back in ω,
    // with the moments U whose product is one, l = h U ω₁, and a_x = h (I_z − I_y)/I_x, that is
    //     ω₂ = (ω₁ − p + (l·l) U ω₁) / (1 + l·U l)  with ω₁ = (x, y, z), p = (a_x yz, a_y zx, a_z xy).
    // We divide first, so that no product overflows that the division would tame.
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    /// [step]
    template <class Real>
    TIMESTEP_INLINE
    Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                       const Vector3<Real>& omega, Real h) const {
        const Vector3<Real>& U = inertia.unit;
        const Vector3<Real> a = h * inertia.ratio;
        const Vector3<Real> l = h * U.cwiseProduct(omega);
        const Real x = omega.x(), y = omega.y(), z = omega.z();
        const Real share =
            1 / (1 + (U.x() * l.x() * l.x() + U.y() * l.y() * l.y() +
                      U.z() * l.z() * l.z()));
        const Real l_l = l.dot(l);
        return Vector3<Real>(
            share * x - a.x() * y * (share * z) + l_l * U.x() * (share * x),
            share * y - a.y() * z * (share * x) + l_l * U.y() * (share * y),
            share * z - a.z() * x * (share * y) + l_l * U.z() * (share * z));
    }
    /// [step]

    // A symmetric body's ω turns about its axis by the angle θ = h (along − across)/across ω_z: that is
    // the exact motion. With tan(θ/2) put as θ/2, no sine and no cosine is needed, the turn is still a
    // turn, energy and momentum stay, and the angle is off by θ³/12.
    /// The same where two moments are equal: nothing is lost either.
    /// [symmetric]
    template <class Real>
    TIMESTEP_INLINE
    Vector3<Real> step(const SymmetricInertia<Real>& inertia,
                       const Vector3<Real>& omega, Real h) const {
        const Real half = h / 2 * inertia.wobble * omega.z();  // tan(θ/2)
        const Real share = 1 / (1 + half * half);
        const Real cosine = 2 * share - 1, sine = 2 * (share * half);
        return {cosine * omega.x() - sine * omega.y(),
                sine * omega.x() + cosine * omega.y(), omega.z()};
    }
    /// [symmetric]

    /// The same in any axes: there and back by way of the principal ones.
    template <class Real>
    TIMESTEP_INLINE
    Vector3<Real> step(const FullInertia<Real>& inertia, const Vector3<Real>& omega, Real h) const {
        const Vector3<Real> turned = inertia.axes.transpose() * omega;
        return inertia.axes * step(inertia.principal, turned, h);
    }
};

inline constexpr PassiveGyroscopic passive_gyroscopic;  ///< the method as a value

}  // namespace timestep
