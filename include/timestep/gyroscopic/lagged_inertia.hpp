#pragma once
/// \file
/// Angular momentum instead of angular velocity, with the lagged inertia.

#include <timestep/rigid/body.hpp>

namespace timestep {

/// Steps the angular momentum L, for which there is no gyroscopic term: L̇ = T (N45). But the
/// orientation needs ω₂ = I₂⁻¹L₂, and the inertia in world coordinates, I₂, depends on the
/// orientation that is not known yet, so I₁ is used. L is kept to roundoff; the energy may grow or
/// fall.
struct LaggedInertia {
    static constexpr const char* name = "momentum, lagged inertia";  ///< for tables and keys
    static constexpr int order = 1;  ///< of the error after a whole run
};

inline constexpr LaggedInertia lagged_inertia;  ///< the method as a value

// The state holds ω instead of L: ω = I⁻¹L at its own orientation. So the state's ω is the old
// momentum over the lagged inertia, and I₂⁻¹L₂ is computed for the next step.
/// One step of `h` seconds without a torque from outside.
template <class Inertia, class Real>
RigidState<Real> step_rotation(const LaggedInertia&, const Inertia& inertia,
                               const RigidState<Real>& s1, Real h) {
    const Vector3<Real> L = angular_momentum(inertia, s1);
    const Quaternion<Real> q2 = rotated(s1.q, s1.omega, h);  // ω = I₁⁻¹L
    const Vector3<Real> omega2 = q2 * inertia.velocity(q2.conjugate() * L);
    return {s1.t + h, q2, omega2};
}

}  // namespace timestep
