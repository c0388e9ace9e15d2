#pragma once
/// \file
/// A body that nothing acts on, as a first-order system: for methods that know nothing of
/// rotations.

#include <timestep/rigid/body.hpp>
#include <timestep/state.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// Orientation and angular velocity in one array y = (q, ω): seven numbers, the quaternion as Eigen
/// keeps it, x, y, z, w, and ω in body coordinates, where the inertia does not change.
///
/// For such a method q is four numbers like any others, and their length is off 1 by its error. Who
/// wants a rotation scales it back: `orientation_scaled` after each step.
template <class Inertia>
struct FreeBody {
    using Real = typename Inertia::Scalar;  ///< the real number type
    using Y = Eigen::Matrix<Real, 7, 1>;    ///< (q, ω)
    Inertia inertia;                        ///< kg m²

    /// Copies the inertia.
    explicit FreeBody(const Inertia& inertia_) : inertia(inertia_) {}

    /// ẏ: of the orientation q̇ = ½ q ω, where ω stands for the quaternion (0, ω) (N42), and of the
    /// angular velocity Euler's equation ω̇ = −I⁻¹(ω × Iω) (N40).
    /// [rate]
    TIMESTEP_INLINE Y operator()(Real, const Y& y) const {
        const Quaternion<Real> q(y[3], y[0], y[1], y[2]);
        const Vector3<Real> omega = y.template tail<3>(), half = omega / 2;
        const Quaternion<Real> turning(0, half.x(), half.y(), half.z());
        const Vector3<Real> torque = -omega.cross(inertia.momentum(omega));
        Y rate;
        rate << quaternion_product(q, turning).coeffs(), inertia.velocity(torque);
        return rate;
    }
    /// [rate]
};

/// A body's state as one array (q, ω).
template <class Real>
FirstOrder<Eigen::Matrix<Real, 7, 1>> stacked(const RigidState<Real>& s) {
    Eigen::Matrix<Real, 7, 1> y;
    y << s.q.coeffs(), s.q.conjugate() * s.omega;
    return {s.t, y};
}

/// The body's state in an array (q, ω).
template <class Real>
RigidState<Real> unstacked(const FirstOrder<Eigen::Matrix<Real, 7, 1>>& s) {
    const Quaternion<Real> q(Eigen::Matrix<Real, 4, 1>(s.y.template head<4>()));
    const Vector3<Real> omega = s.y.template tail<3>();
    return {s.t, q, q * omega};
}

/// The same array with its quaternion scaled back to length one.
template <class Real>
FirstOrder<Eigen::Matrix<Real, 7, 1>> orientation_scaled(
    const FirstOrder<Eigen::Matrix<Real, 7, 1>>& s) {
    FirstOrder<Eigen::Matrix<Real, 7, 1>> scaled = s;
    scaled.y.template head<4>() /= norm(scaled.y.template head<4>());
    return scaled;
}

}  // namespace timestep
