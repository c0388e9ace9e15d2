#pragma once
/// \file
/// Bullet: the talk's solver, and a guard that a light body meets.

#include <cmath>
#include <limits>

#include "guarded_newton.hpp"
#include "new_spin.hpp"

namespace timestep {

/// The solver: where the determinant is at most ε, it is not inverted, and the solution becomes the
/// determinant squared times what it should be. So the torque is gone, and nobody is told. In float
/// that is so where the moments' geometric mean is below ∛ε = 0.005 kg m².
struct BulletGyroscopic {
    static constexpr const char* name = "Bullet";  ///< for tables and keys
    static constexpr int order = 1;                ///< of the error after a whole run

    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia, const Vector3<Real>& omega,
                                       Real h) const {
        return guarded_newton(inertia, omega, h, [](Real determinant) -> Real {
            const bool inverted = std::abs(determinant) > std::numeric_limits<Real>::epsilon();
            return inverted ? 1 / determinant : determinant;
        });
    }
};

/// The whole body.
struct BulletSpin : NewSpin<BulletGyroscopic> {};

inline constexpr BulletSpin bullet_spin;  ///< the method as a value

}  // namespace timestep
