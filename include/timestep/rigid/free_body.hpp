#pragma once
/// \file
/// A free body as a first-order system, for methods that know nothing of rotations.

#include <timestep/rigid/body.hpp>
#include <timestep/state.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// Orientation and angular velocity in one array y = (q, ω): seven numbers, the quaternion in
/// Eigen's order x, y, z, w, and ω in body coordinates, where the inertia is constant.
///
/// For such a method q is four numbers like any others, so its length differs from 1 by the
/// method's error. Call `orientation_scaled` after each step to get a rotation.
template <class Inertia>
struct FreeBody {
    using Real = typename Inertia::Scalar;  ///< the real number type
    using Y = Eigen::Matrix<Real, 7, 1>;    ///< (q, ω)
    Inertia inertia;                        ///< kg m²

    /// Copies the inertia.
    explicit FreeBody(const Inertia& inertia_) : inertia(inertia_) {}

    /// ẏ = (q̇, ω̇): q̇ = ½ q ω, where ω stands for the quaternion (0, ω) (N42), and Euler's equation
    /// ω̇ = −I⁻¹(ω × Iω) (N40).
    TIMESTEP_INLINE Y operator()(Real, const Y& y) const {
        const Quaternion<Real> q(y[3], y[0], y[1], y[2]);
        const Vector3<Real> omega = y.template tail<3>(), half = omega / 2;
        const Quaternion<Real> turning(0, half.x(), half.y(), half.z());
        const Vector3<Real> torque = -omega.cross(inertia.momentum(omega));
        Y rate;
        rate << quaternion_product(q, turning).coeffs(), inertia.velocity(torque);
        return rate;
    }
};

/// A body's state as one array (q, ω).
template <class Real>
FirstOrder<Eigen::Matrix<Real, 7, 1>> stacked(const RigidState<Real>& s) {
    Eigen::Matrix<Real, 7, 1> y;
    y << s.q.coeffs(), s.q.conjugate() * s.omega;
    return {s.t, y};
}

/// The state that an array (q, ω) holds.
template <class Real>
RigidState<Real> unstacked(const FirstOrder<Eigen::Matrix<Real, 7, 1>>& s) {
    const Quaternion<Real> q(Eigen::Matrix<Real, 4, 1>(s.y.template head<4>()));
    const Vector3<Real> omega = s.y.template tail<3>();
    return {s.t, q, q * omega};
}

/// An array (q, ω) with its quaternion scaled back to length one.
template <class Real>
FirstOrder<Eigen::Matrix<Real, 7, 1>> orientation_scaled(
    const FirstOrder<Eigen::Matrix<Real, 7, 1>>& s) {
    FirstOrder<Eigen::Matrix<Real, 7, 1>> scaled = s;
    scaled.y.template head<4>() /= norm(scaled.y.template head<4>());
    return scaled;
}

}  // namespace timestep
