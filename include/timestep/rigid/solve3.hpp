#pragma once
/// \file
/// Three equations in three unknowns, by hand.

#include <timestep/inline.hpp>
#include <timestep/rigid/rotation.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// The x with A x = b, where `a`, `b` and `c` are the columns of A (Cramer's rule). Each unknown is
/// a volume over the volume of the three columns, their determinant; 0/0 where that vanishes.
template <class Real>
TIMESTEP_INLINE Vector3<Real> solve3(const Vector3<Real>& a, const Vector3<Real>& b,
                                     const Vector3<Real>& c, const Vector3<Real>& right) {
    const Vector3<Real> b_c = b.cross(c), c_a = c.cross(a), a_b = a.cross(b);
    const Real volume = dot(a, b_c);
    const Real share = 1 / volume;  // a division takes as long as ten products
    return share * Vector3<Real>(dot(right, b_c), dot(right, c_a), dot(right, a_b));
}

/// The x with A x = b.
template <class Real>
TIMESTEP_INLINE Vector3<Real> solve3(const Matrix3<Real>& A, const Vector3<Real>& right) {
    return solve3<Real>(A.col(0), A.col(1), A.col(2), right);
}

}  // namespace timestep
