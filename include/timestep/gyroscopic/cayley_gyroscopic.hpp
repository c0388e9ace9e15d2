#pragma once
/// \file
/// A relative of the passive step, of order two: it keeps the energy for any step.

#include <timestep/gyroscopic/passive_gyroscopic.hpp>

namespace timestep {

/// The passive step uses L of the old state and ω of the new one. The Cayley step uses L in the
/// middle of the step, from half a step of explicit Euler, and the mean of the old and the new ω:
/// I(ω₂ − ω₁) = h L* × ½(ω₁ + ω₂) with L* = L₁ − h/2 ω₁ × L₁. This equation is linear too, and the
/// torque does no work: with ½(ω₁ + ω₂) on both sides, the energies are equal. There is no branch,
/// no solve, and no divisor that could vanish.
///
/// Order two. The energy stays for any inertia, spin and step, to a few roundoffs. |L| is kept to
/// order two only, within the bounds that the energy sets, and creeps up or down: from h|ω| of
/// about 0.3 on, a wheel loses half of its spin within a minute or two; with the passive step and
/// the half-step Jacobian it keeps its spin. CalmHalfStep keeps |L| too. Steps with h|ω| beyond 1
/// are safe but not accurate. If (hω)² is too large for a number (hω beyond 1e154, in `float` 1e19,
/// less by some roots of the moments' ratio), three moments return NaN.
struct CayleyGyroscopic : PassiveIfSymmetric<CayleyGyroscopic> {
    static constexpr const char* name = "Cayley";  ///< for tables and keys
    static constexpr int order = 2;                ///< of the error of ω after a whole run
    using PassiveIfSymmetric<CayleyGyroscopic>::step;

    // In y = √I ω the energy is ½|y|². With t_x = h/2 L*_x/√(I_y I_z) and so on round that reads
    //     y₂ − y₁ = t × (y₁ + y₂),  solved  y₂ = y₁ + 2 (t × y₁ + t × (t × y₁)) / (1 + t·t):
    // y turns about t by the angle 2 atan|t|. Back in ω, with l = h/2 L* and V = I⁻¹, t × y is
    // V (l × ω), and t·t is l_x² V_y V_z and so on round: no root is left. Instead of I the formula
    // has U, the moments whose product is one. Dividing first keeps products from overflowing.
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
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
};

inline constexpr CayleyGyroscopic cayley_gyroscopic;  ///< the method as a value

}  // namespace timestep
