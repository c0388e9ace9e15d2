#pragma once
/// \file
/// Angular momentum instead of angular velocity, with the lagged inertia.

#include <timestep/rigid/body.hpp>

namespace timestep {

/// Steps the angular momentum L, in which no gyroscopic term appears: L̇ = T (N45). But the
/// orientation needs ω₂ = I₂⁻¹L₂, and I₂, the inertia in world coordinates, depends on the
/// orientation that is not known yet: I₁ has to do. L is kept to roundoff; the energy is anybody's.
struct LaggedInertia {
    static constexpr const char* name = "momentum, lagged inertia";  ///< for tables and keys
    static constexpr int order = 1;  ///< of the error after a whole run
};

inline constexpr LaggedInertia lagged_inertia;  ///< the method as a value

// The state holds ω instead of L. In it ω = I⁻¹L at the orientation of the same moment, so the
// lagged inertia with the old momentum is the ω that the state holds, and I₂⁻¹L₂ is made for the
// next step.
/// One step of `h` seconds without a torque from outside.
/// [step]
template <class Inertia, class Real>
RigidState<Real> step_rotation(const LaggedInertia&, const Inertia& inertia,
                               const RigidState<Real>& s1, Real h) {
    const Vector3<Real> L = angular_momentum(inertia, s1);
    const Quaternion<Real> q2 = rotated(s1.q, s1.omega, h);  // ω = I₁⁻¹L
    const Vector3<Real> omega2 = q2 * inertia.velocity(q2.conjugate() * L);
    return {s1.t + h, q2, omega2};
}
/// [step]

}  // namespace timestep
