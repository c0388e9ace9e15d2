#pragma once
/// \file
/// The talk's solver: implicit Euler on the gyroscopic torque, one Newton–Raphson iteration.

#include <timestep/inline.hpp>
#include <timestep/rigid/symmetric_about.hpp>
#include <timestep/rigid/solve3.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// Implicit Euler's ω₂ solves I(ω₂ − ω₁) + h ω₂ × Iω₂ = 0 in body coordinates, where I is constant.
/// One Newton–Raphson iteration from ω₁ is the talk's solver (N47, N48). Bodies tumble on time and
/// lose energy. The solver is not safe: for h|ω| near 1 and above, the single iteration may add
/// energy without limit (N51). PassiveGyroscopic never adds energy.
struct ImplicitGyroscopic : InOtherAxes<ImplicitGyroscopic> {
    static constexpr const char* name = "one Newton step";  ///< for tables and keys
    static constexpr int order = 1;                         ///< of the error after a whole run
    using InOtherAxes<ImplicitGyroscopic>::step;

    // The residual at ω₁ is h ω × Iω. Its derivative, by the product rule, a × b = skew(a) b and
    // −b × a = −skew(b) a:  J = I + h (skew(ω) I − skew(Iω)).
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    /// [step]
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const FullInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        const Matrix3<Real>& I = inertia.unit;  // so scaled that no determinant underflows
        const Vector3<Real> L = times(I, omega);
        const Vector3<Real> residual = h * omega.cross(L);
        const Matrix3<Real> J = I + h * (skew_times(omega, I) - skew(L));
        return omega - solve3(J, residual);
    }
    /// [step]

    // With three moments only, each row can be divided by its own, and of I nothing is left but the
    // ratios a₁ = (I₃ − I₂)/I₁ and so on round:
    //     residual  h (a₁ω₂ω₃, a₂ω₃ω₁, a₃ω₁ω₂),    J = | 1     ha₁ω₃  ha₁ω₂ |
    //                                                   | ha₂ω₃  1     ha₂ω₁ |
    //                                                   | ha₃ω₂  ha₃ω₁  1    |
    /// One step of `h` seconds of a body with three moments; `omega` in body coordinates, rad/s.
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        const Vector3<Real> a = h * inertia.ratio;
        const Real x = omega.x(), y = omega.y(), z = omega.z();
        const Vector3<Real> residual(a.x() * y * z, a.y() * z * x, a.z() * x * y);
        const Vector3<Real> column1(1, a.y() * z, a.z() * y);
        const Vector3<Real> column2(a.x() * z, 1, a.z() * x);
        const Vector3<Real> column3(a.x() * y, a.y() * x, 1);
        return omega - solve3(column1, column2, column3, residual);
    }

    // The torque of a symmetric body has no component along its axis: ω_z is known, the equations
    // for the other two are linear in them, and one iteration is the solution:
    //     x₂ + θ y₂ = x₁,  y₂ − θ x₂ = y₁  with θ = h (along − across)/across ω_z.
    /// One step of `h` seconds of a body with two equal moments; `omega` in body coordinates,
    /// rad/s.
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const SymmetricInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        const Real angle = h * inertia.precession_ratio * omega.z();
        const Real share = 1 / (1 + angle * angle);
        return {share * (omega.x() - angle * omega.y()), share * (omega.y() + angle * omega.x()),
                omega.z()};
    }
};

inline constexpr ImplicitGyroscopic implicit_gyroscopic;  ///< the method as a value

}  // namespace timestep
