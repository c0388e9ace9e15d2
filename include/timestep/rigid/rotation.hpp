#pragma once
/// \file
/// Three dimensions: vectors, matrices, and quaternions for the orientation of a body.

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <timestep/inline.hpp>
#include <timestep/own_math.hpp>
#include <timestep/sums.hpp>

namespace timestep {

template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;  ///< three numbers: along x, y and z
template <class Real>
using Matrix3 = Eigen::Matrix<Real, 3, 3>;  ///< three rows of three numbers
template <class Real>
using Quaternion = Eigen::Quaternion<Real>;  ///< a rotation from body to world coordinates

/// The matrix of a cross product: skew(a) b = a × b (N47).
template <class Real>
Matrix3<Real> skew(const Vector3<Real>& a) noexcept {
    Matrix3<Real> s;
    s << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return s;
}

/// skew(a) B: the cross products of a and B's columns.
template <class Real>
TIMESTEP_INLINE Matrix3<Real> skew_times(const Vector3<Real>& a, const Matrix3<Real>& B) noexcept {
    Matrix3<Real> product;
    for (int i = 0; i < 3; ++i) product.col(i) = a.cross(B.col(i));
    return product;
}

/// The world coordinates of a vector whose body coordinates are `v`: R v, where `R` is the
/// orientation as a matrix. Spelt out, because at -O2 a compiler may call Eigen's product three
/// times.
template <class Real>
TIMESTEP_INLINE Vector3<Real> in_world(const Matrix3<Real>& R, const Vector3<Real>& v) noexcept {
    const Real x = v.x(), y = v.y(), z = v.z();
    return {R(0, 0) * x + R(0, 1) * y + R(0, 2) * z, R(1, 0) * x + R(1, 1) * y + R(1, 2) * z,
            R(2, 0) * x + R(2, 1) * y + R(2, 2) * z};
}

/// The body coordinates of a vector whose world coordinates are `v`: Rᵀ v.
template <class Real>
TIMESTEP_INLINE Vector3<Real> in_body(const Matrix3<Real>& R, const Vector3<Real>& v) noexcept {
    const Real x = v.x(), y = v.y(), z = v.z();
    return {R(0, 0) * x + R(1, 0) * y + R(2, 0) * z, R(0, 1) * x + R(1, 1) * y + R(2, 1) * z,
            R(0, 2) * x + R(1, 2) * y + R(2, 2) * z};
}

/// How far apart two unit quaternions' orientations are: 2 sin(α/2) for an angle α between them.
/// That is the angle in radians while it is small, and at most 2.
template <class Real>
Real apart(const Quaternion<Real>& p, const Quaternion<Real>& q) {
    return 2 * std::min(Real(1), norm(quaternion_product(p.conjugate(), q).vec()));
}

/// A quaternion over its length; NaN if that is zero. (Eigen's `normalized` branches on zero, and
/// lanes have no branches.)
template <class Real>
TIMESTEP_INLINE Quaternion<Real> over_its_length(const Quaternion<Real>& q) noexcept {
    using std::sqrt;
    return Quaternion<Real>(q.coeffs() / sqrt(dot(q.coeffs(), q.coeffs())));
}

/// The orientation after `h` seconds at the angular velocity `omega`, in rad/s and world
/// coordinates (N42): q̇ = ½ ω q, where ω stands for the quaternion (0, ω). One Euler step leaves
/// the unit quaternions, so the result is scaled back to length one. A step rotates the body by 2
/// atan(h|ω|/2) instead of h|ω|, which is less than half a turn for any spin, as long as the square
/// of h|ω|/2 is a number: to 3e19 in `float`, 1e154 in `double`. Beyond, the quaternion is zero,
/// and `is_finite` of a state is false.
template <class Real>
Quaternion<Real> rotated(const Quaternion<Real>& q1, const Vector3<Real>& omega, Real h) noexcept {
    const Vector3<Real> half = h / 2 * omega;
    const Quaternion<Real> rate = vector_product(half, q1);
    return over_its_length(Quaternion<Real>(q1.coeffs() + rate.coeffs()));
}

// q̇ = ½ q ω with ω in the body. A constant ω rotates the body about ω by h|ω|. The quaternion
// 1 + h/2 ω, scaled to length one, rotates it about that axis by 2 atan(h|ω|/2), which is
// (h|ω|)³/12 less: no sine, no cosine, and little enough for order two.
/// The orientation after `h` seconds at the angular velocity `omega`, in rad/s and BODY
/// coordinates: the other side of the product. With the mean of the old and the new ω it is of
/// order two. The bounds of `rotated` hold.
template <class Real>
TIMESTEP_INLINE Quaternion<Real> rotated_in_body(const Quaternion<Real>& q1,
                                                 const Vector3<Real>& omega, Real h) noexcept {
    const Real half = h / 2;
    const Vector3<Real> v = half * omega;
    const Quaternion<Real> cayley(1, v.x(), v.y(), v.z());
    return over_its_length(quaternion_product(q1, cayley));
}

/// The quaternion of a rotation by |v| rad about v: the exact motion for a constant angular
/// velocity.
template <class Real>
TIMESTEP_INLINE Quaternion<Real> rotation_by(const Vector3<Real>& v) noexcept {
    const Real half = norm(v) / 2;
    const auto [sine, cosine] = sine_cosine(half);
    const Real share = half > 0 ? sine / half / 2 : Real(0.5);
    return Quaternion<Real>(cosine, share * v.x(), share * v.y(), share * v.z());
}

}  // namespace timestep
