#pragma once
/// \file
/// The gyroscopic torque, dropped.

#include <timestep/inline.hpp>
#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// ω₂ = ω₁: most engines drop the term, or have it off by default (N44). No body blows up, and none
/// tumbles: ω is constant in the world, where the angular momentum should be.
struct NoGyroscopic {
    static constexpr const char* name = "dropped";  ///< for tables and keys
    static constexpr int order = 0;                 ///< it does not converge to the motion

    /// Returns `omega` (body coordinates, rad/s) unchanged.
    template <class Inertia, class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const Inertia&, const Vector3<Real>& omega,
                                                     Real) const noexcept {
        return omega;
    }
};

inline constexpr NoGyroscopic no_gyroscopic;  ///< the method as a value

}  // namespace timestep
