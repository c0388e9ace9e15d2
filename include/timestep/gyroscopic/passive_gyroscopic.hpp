#pragma once
/// \file
/// A gyroscopic step that never adds energy: the default for games.

#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// The passive step. It takes the angular momentum L from the old state and the angular velocity
/// from the new one, I(ω₂ − ω₁) = h L₁ × ω₂ (as the engine ODE does), so that the equation is linear
/// and the torque does no work. In energy coordinates its solution is four lines without a branch, and
/// without a determinant that could vanish.
///
/// Order one, as the talk's solver; the energy never grows, for any inertia, spin and step (N51). The
/// angular momentum is kept to order one only.
struct PassiveGyroscopic {
    static constexpr const char* name = "passive";  ///< for tables and keys
    static constexpr int order = 1;                 ///< of the error after a whole run

    // In y = √I ω the energy is ½|y|², and with k₁ = h L₁/√(I₂I₃) and so on round the equation is
    //     y₂ − k × y₂ = y₁.
    // Solved: dot with k gives k·y₂ = k·y₁, cross with k gives k × y₂, and
    //     y₂ = (y₁ + k × y₁ + (k·y₁) k) / (1 + k·k).
    // No energy is added: k × y₂ is at right angles to y₂, so |y₁|² = |y₂|² + |k × y₂|².
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    /// [step]
    template <class Real>
    Vector3<Real> step(const PrincipalInertia<Real>& inertia, const Vector3<Real>& omega,
                       Real h) const {
        const Vector3<Real> k = h * inertia.passive.cwiseProduct(omega);
        const Vector3<Real> y = inertia.root.cwiseProduct(omega) / (1 + k.dot(k));
        const Vector3<Real> y2 = y + k.cross(y) + k.dot(y) * k;
        return y2.cwiseQuotient(inertia.root);
    }
    /// [step]

    // A symmetric body's ω turns about its axis by the angle θ = h (along − across)/across ω_z: that is
    // the exact motion. With tan(θ/2) put as θ/2, no sine and no cosine is needed, the turn is still a
    // turn, energy and momentum stay, and the angle is off by θ³/12.
    /// The same where two moments are equal: nothing is lost either.
    /// [symmetric]
    template <class Real>
    Vector3<Real> step(const SymmetricInertia<Real>& inertia, const Vector3<Real>& omega,
                       Real h) const {
        const Real half = h / 2 * inertia.wobble * omega.z();  // tan(θ/2)
        const Real x = omega.x() - half * omega.y();
        const Real y = omega.y() + half * omega.x();
        const Real share = 1 / (1 + half * half);
        return {share * (x - half * y), share * (y + half * x), omega.z()};
    }
    /// [symmetric]

    /// The same in any axes: there and back by way of the principal ones.
    template <class Real>
    Vector3<Real> step(const FullInertia<Real>& inertia, const Vector3<Real>& omega, Real h) const {
        const Vector3<Real> turned = inertia.axes.transpose() * omega;
        return inertia.axes * step(inertia.principal, turned, h);
    }
};

inline constexpr PassiveGyroscopic passive_gyroscopic;  ///< the method as a value

}  // namespace timestep
