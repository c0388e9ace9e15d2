#pragma once
/// \file
/// The gyroscopic torque, taken explicitly.

#include <timestep/inline.hpp>
#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// ω₂ = ω₁ − h I⁻¹(ω₁ × Iω₁) (N42, N43). The torque is quadratic in ω and extrapolated: the energy
/// grows, the torque with it, and the body blows up.
struct ExplicitGyroscopic {
    static constexpr const char* name = "explicit";  ///< for tables and keys
    static constexpr int order = 1;                  ///< of the error after a whole run

    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    template <class Inertia, class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const Inertia& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        const Vector3<Real> torque = -omega.cross(inertia.momentum(omega));
        return omega + h * inertia.velocity(torque);
    }
};

inline constexpr ExplicitGyroscopic explicit_gyroscopic;  ///< the method as a value

}  // namespace timestep
