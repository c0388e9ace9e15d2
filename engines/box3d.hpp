#pragma once
/// \file
/// Box3D: the talk's solver in substeps, with a guard and a cap.

#include <cmath>
#include <limits>

#include "guarded_newton.hpp"
#include "new_spin.hpp"

namespace timestep {

/// The solver: no change at all where the determinant is at most 1000 times the least normal
/// number. In float that is so for moments below 2e-12 kg m².
struct Box3dGyroscopic {
    static constexpr const char* name = "Box3D";  ///< for tables and keys
    static constexpr int order = 1;               ///< of the error after a whole run

    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia, const Vector3<Real>& omega,
                                       Real h) const {
        return guarded_newton(inertia, omega, h, [](Real determinant) -> Real {
            const bool solved = std::abs(determinant) > 1000 * std::numeric_limits<Real>::min();
            return solved ? 1 / determinant : 0;
        });
    }
};

/// The whole body. A step is four substeps, which Box3D's examples take. No body turns by more than
/// 45° in a step: |ω| is capped at π/4 a step, that is at h|ω| = 0.2 a substep, where one Newton
/// step is hardly ever wrong.
struct Box3dSpin {
    static constexpr const char* name = "Box3D";  ///< for tables and keys
    static constexpr int order = 1;               ///< of the error after a whole run

    /// One step of `h` seconds.
    template <class Real>
    TIMESTEP_INLINE SpinState<Real> step(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s1,
                                         Real h) const {
        using std::abs;
        const Real cap = Real(0.785398163397448309616L) / abs(h), part = h / 4;
        SpinState<Real> s = s1;
        for (int substep = 0; substep < 4; ++substep) {
            s.omega = Box3dGyroscopic{}.step(inertia, s.omega, part);
            const Real speed = s.omega.norm();
            if (speed > cap) s.omega *= cap / speed;
            s.q = rotated_in_body(s.q, s.omega, part);
        }
        s.t = s1.t + h;
        return s;
    }
};

inline constexpr Box3dSpin box3d_spin;  ///< the method as a value

}  // namespace timestep
