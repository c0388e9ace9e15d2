#pragma once
/// \file
/// The state of a free body with its angular velocity in its own axes.

#include <cmath>

#include <timestep/rigid/body.hpp>

namespace timestep {

/// The state of a body that rotates about its centre of mass, as whole-body methods keep it. In the
/// body's axes the inertia is constant, so ω stays there: no step rotates it into the world and
/// back.
template <class Real>
struct SpinState {
    using Scalar = Real;  ///< the real number type

    Real t;               ///< time, s
    Quaternion<Real> q;   ///< orientation: q v q* is in world coordinates what v is in the body's
    Vector3<Real> omega;  ///< angular velocity in BODY coordinates, rad/s
};

/// `s` with ω in body coordinates.
template <class Real>
SpinState<Real> in_body(const RigidState<Real>& s) noexcept {
    return {s.t, s.q, s.q.conjugate() * s.omega};
}

/// `s` with ω in world coordinates.
template <class Real>
RigidState<Real> in_world(const SpinState<Real>& s) noexcept {
    return {s.t, s.q, s.q * s.omega};
}

/// Whether every part of the state is a finite number and the quaternion is not zero.
template <class Real>
[[nodiscard]] bool is_finite(const SpinState<Real>& s) {
    return std::isfinite(s.t) && s.q.coeffs().allFinite() && !s.q.coeffs().isZero(0) &&
           s.omega.allFinite();
}

}  // namespace timestep
