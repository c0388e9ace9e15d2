#pragma once
/// \file
/// The talk's solver with the moments in kg m², as engines write it: its determinant has a unit.

#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// One Newton step on implicit Euler's equation, by Cramer's rule: J d = h ω × Iω and ω₂ = ω − d
/// with J = I + h (skew(ω) I − skew(Iω)). The determinant is about I₁I₂I₃, in (kg m²)³: a body half
/// as long has one 32,000 times smaller. `one_over(determinant)` says what to divide by when that
/// is small.
template <class Real, class OneOver>
TIMESTEP_INLINE Vector3<Real> guarded_newton(const PrincipalInertia<Real>& inertia, const Vector3<Real>& omega, Real h,
                                             const OneOver& one_over) {
    const Vector3<Real> L = inertia.momentum(omega);
    const Matrix3<Real> I = inertia.moments.asDiagonal();
    const Matrix3<Real> J = I + h * (skew(omega) * I - skew(L));
    const Vector3<Real> right = h * omega.cross(L);
    const Vector3<Real> a = J.col(0), b = J.col(1), c = J.col(2);
    const Vector3<Real> b_c = b.cross(c), c_a = c.cross(a), a_b = a.cross(b);
    const Real share = one_over(a.dot(b_c));
    return omega - share * Vector3<Real>(right.dot(b_c), right.dot(c_a), right.dot(a_b));
}

}  // namespace timestep
