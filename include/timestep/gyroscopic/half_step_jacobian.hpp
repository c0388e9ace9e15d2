#pragma once
/// \file
/// The talk's solver with half the step in its Jacobian: order two at the same price.

#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/solve3.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// ImplicitGyroscopic with h/2 instead of h in the Jacobian, and no other change: Kahan's
/// discretisation (1993), found for Euler's equations also by Hirota and Kimura (2000). Order two;
/// a step of −h undoes a step of h; the energy oscillates and does not drift. Two quantities are
/// kept exactly and confine ω to a closed curve near the true one.
///
/// If h|ω| is below 2 at the start and h is constant, the energy never exceeds 1/(1 − (h|ω|/2)²)
/// times that at the start. Beyond, the Jacobian may be singular: the step may add energy without
/// limit, or divide by zero. If steps vary or impulses act, gains add up. CalmHalfStep keeps the
/// energy in those cases too.
struct HalfStepJacobian : PassiveIfSymmetric<HalfStepJacobian> {
    static constexpr const char* name = "half-step Jacobian";  ///< for tables and keys
    static constexpr int order = 2;  ///< of the error of ω after a whole run
    using PassiveIfSymmetric<HalfStepJacobian>::step;

    // The torque −ω × Iω is quadratic in ω. The mean of the torques at both ends, with the one at
    // the end linearised about ω₁, where ω has changed by d and G is the derivative of ω × Iω, is
    //     −(ω × Iω + G d/2),  so  (I + h/2 G) d = −h ω × Iω.
    // Each product of two components x y has become (x₁ y₂ + x₂ y₁)/2, the same from both ends of
    // the step: that is why it is reversible, and of order two.
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    /// [step]
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const FullInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        const Matrix3<Real>& I = inertia.unit;
        const Vector3<Real> L = times(I, omega);
        const Vector3<Real> residual = h * omega.cross(L);
        const Matrix3<Real> J = I + h / 2 * (skew_times(omega, I) - skew(L));
        return omega - solve3(J, residual);
    }
    /// [step]

    /// One step of `h` seconds of a body with three moments, each row divided by its own; `omega`
    /// in body coordinates, rad/s.
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        const Real half = h / 2;
        const Vector3<Real> a = half * inertia.ratio;
        const Real x = omega.x(), y = omega.y(), z = omega.z();
        const Vector3<Real> residual(2 * (a.x() * y * z), 2 * (a.y() * z * x), 2 * (a.z() * x * y));
        const Vector3<Real> column1(1, a.y() * z, a.z() * y);
        const Vector3<Real> column2(a.x() * z, 1, a.z() * x);
        const Vector3<Real> column3(a.x() * y, a.y() * x, 1);
        return omega - solve3(column1, column2, column3, residual);
    }
};

inline constexpr HalfStepJacobian half_step_jacobian;  ///< the method as a value

}  // namespace timestep
