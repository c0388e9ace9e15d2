#pragma once
/// \file
/// Three dimensions: vectors, and the quaternion that says how a body is turned.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace timestep {

template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;  ///< three numbers: along x, y and z
template <class Real>
using Matrix3 = Eigen::Matrix<Real, 3, 3>;  ///< three rows of three numbers
template <class Real>
using Quaternion = Eigen::Quaternion<Real>;  ///< a rotation from body to world coordinates

/// The matrix that does what the cross product does: skew(a) b = a × b (N47).
/// [skew]
template <class Real>
Matrix3<Real> skew(const Vector3<Real>& a) {
    Matrix3<Real> s;
    s << 0, -a.z(), a.y(),
         a.z(), 0, -a.x(),
        -a.y(), a.x(), 0;
    return s;
}
/// [skew]

/// The attitude after `h` seconds at the angular velocity `omega`, in rad/s and world coordinates
/// (N42): q̇ = ½ ω q, where ω stands for the quaternion (0, ω). One Euler step leaves the unit
/// quaternions, so the result is scaled back to length one. A step turns the body by
/// 2 atan(h|ω|/2) instead of h|ω|, short of half a turn whatever the spin, as long as the square of
/// h|ω|/2 is a number: to 3e19 in `float`, 1e154 in `double`. Beyond, the quaternion is zero, which
/// `is_finite` of a state refuses.
/// [attitude]
template <class Real>
Quaternion<Real> turned(const Quaternion<Real>& q1, const Vector3<Real>& omega, Real h) {
    const Vector3<Real> half = h / 2 * omega;
    const Quaternion<Real> rate = Quaternion<Real>(0, half.x(), half.y(), half.z()) * q1;
    return Quaternion<Real>(q1.coeffs() + rate.coeffs()).normalized();
}
/// [attitude]

}  // namespace timestep
