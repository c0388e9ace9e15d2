#pragma once
/// \file
/// Jolt, PhysX, Rapier, Avian: explicit Euler on the angular momentum, scaled back to its length.

#include "new_spin.hpp"

namespace timestep {

/// L* = L₁ − h ω₁ × L₁ and L₂ = L* |L₁|/|L*|. A step of explicit Euler leaves the sphere of
/// constant |L| along a tangent, and is brought back. |L| stays for every step. The energy does not:
/// it ends at |L|²/2I of the middle moment, where the true motion never rests.
struct JoltGyroscopic {
    static constexpr const char* name = "Jolt";  ///< for tables and keys
    static constexpr int order = 1;              ///< of the error after a whole run

    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    /// [step]
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia, const Vector3<Real>& omega,
                                       Real h) const {
        const Vector3<Real> L = inertia.unit.cwiseProduct(omega);
        const Vector3<Real> after = L - h * omega.cross(L);
        const Real length = after.norm();
        const Real share = length > 0 ? L.norm() / length : Real(0);
        return share * after.cwiseQuotient(inertia.unit);
    }
    /// [step]
};

/// The whole body.
struct JoltSpin : NewSpin<JoltGyroscopic> {};

inline constexpr JoltSpin jolt_spin;  ///< the method as a value

}  // namespace timestep
