#pragma once
/// \file
/// The passive step's sibling of order two: it keeps the energy, whatever the step.

#include <timestep/gyroscopic/passive_gyroscopic.hpp>

namespace timestep {

/// The passive step takes L from the old state and ω from the new one. Its sibling takes L from the
/// middle of the step, by half a step of explicit Euler, and the mean of the old and the new ω:
/// I(ω₂ − ω₁) = h L* × ½(ω₁ + ω₂) with L* = L₁ − h/2 ω₁ × L₁. Again linear, and again the torque
/// does no work: with ½(ω₁ + ω₂) on both sides, the energies are equal. No branch, no solve, and
/// nothing that could vanish.
///
/// Order two; the energy stays for any inertia, spin and step, to a few roundoffs. |L| is kept to
/// order two only, within what the energy allows, and creeps, up or down: from h|ω| of some 0.3 on
/// a wheel loses half of its spin within a minute or two, which the passive step and the half-step
/// Jacobian leave it. CalmHalfStep keeps |L|, too. Steps with h|ω| beyond 1 are safe and no longer
/// right. Where (hω)² is too large for a number (hω beyond 1e154, in float 1e19, less by some roots
/// of the moments' ratio) three moments give back NaN.
struct CayleyGyroscopic {
    static constexpr const char* name = "Cayley";  ///< for tables and keys
    static constexpr int order = 2;                ///< of the error of ω after a whole run

    // In y = √I ω the energy is ½|y|². With t_x = h/2 L*_x/√(I_y I_z) and so on round that reads
    //     y₂ − y₁ = t × (y₁ + y₂),  solved  y₂ = y₁ + 2 (t × y₁ + t × (t × y₁)) / (1 + t·t):
    // y turns about t by the angle 2 atan|t|. Back in ω, with l = h/2 L* and V = I⁻¹, t × y is
    // V (l × ω), and t·t is l_x² V_y V_z and so on round: no root is left. Instead of I we take U,
    // the moments whose product is one. We divide first, so that no product overflows that the
    // division would tame.
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    /// [step]
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                                       const Vector3<Real>& omega, Real h) const noexcept {
        const Vector3<Real>& U = inertia.unit;
        const Vector3<Real>& a = inertia.ratio;
        const Vector3<Real> V = U.cwiseInverse();
        const Real half = h / 2;
        const Vector3<Real> turn = half * omega;
        const Real x = turn.x(), y = turn.y(), z = turn.z();
        const Vector3<Real> l(U.x() * (x - a.x() * y * z), U.y() * (y - a.y() * z * x),
                              U.z() * (z - a.z() * x * y));
        const Real t_t = (l.x() * V.y()) * (l.x() * V.z()) + (l.y() * V.z()) * (l.y() * V.x()) +
                         (l.z() * V.x()) * (l.z() * V.y());
        const Real share = 2 / (1 + t_t);
        const Vector3<Real> part = share * omega;
        const Vector3<Real> t_y = V.cwiseProduct(l.cross(part));
        return omega + t_y + V.cwiseProduct(l.cross(t_y));
    }
    /// [step]

    /// The same where two moments are equal: the passive step, which keeps energy and |L| there.
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const SymmetricInertia<Real>& inertia,
                                       const Vector3<Real>& omega, Real h) const noexcept {
        return passive_gyroscopic.step(inertia, omega, h);
    }

    /// The same with another odd axis.
    template <Axis axis, class Real>
    TIMESTEP_INLINE Vector3<Real> step(const SymmetricAbout<axis, Real>& inertia,
                                       const Vector3<Real>& omega, Real h) const noexcept {
        return inertia.from_z(step(inertia.about_z, inertia.to_z(omega), h));
    }

    /// The same in any axes: there and back by way of the principal ones.
    template <class Real>
    Vector3<Real> step(const FullInertia<Real>& inertia, const Vector3<Real>& omega,
                       Real h) const noexcept {
        const Vector3<Real> turned = in_body(inertia.axes, omega);
        return in_world(inertia.axes, step(inertia.principal, turned, h));
    }
};

inline constexpr CayleyGyroscopic cayley_gyroscopic;  ///< the method as a value

}  // namespace timestep
