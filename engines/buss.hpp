#pragma once
/// \file
/// Buss's explicit steps: the body turns by a mean spin, L stays where it is in the world.

#include <timestep/rigid/spin_state.hpp>

namespace timestep {

/// The body turns by ω̄ = ω₁ + h/2 ω̇₁, the spin in the middle of the step by its slope at the start. L
/// turns back in the body's axes by the same turn, so in the world it stays, and ω₂ is I⁻¹L₂. Explicit.
/// Samuel Buss, *Accurate and efficient simulation of rigid-body rotations* (2000); `Augmented` adds
/// h²/12 ω̇₁ × ω₁, the first term that counts how the axis itself moves.
template <bool Augmented>
struct BussSpin {
    static constexpr const char* name = Augmented ? "Buss augmented" : "Buss 2";  ///< for tables and keys
    static constexpr int order = 2;                                               ///< of the error after a whole run

    /// One step of `h` seconds.
    /// [step]
    template <class Real>
    TIMESTEP_INLINE SpinState<Real> step(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s1,
                                         Real h) const {
        const Vector3<Real>& w1 = s1.omega;
        const Vector3<Real> L1 = inertia.unit.cwiseProduct(w1);
        const Vector3<Real> slope = -w1.cross(L1).cwiseQuotient(inertia.unit);
        Vector3<Real> mean = w1 + h / 2 * slope;
        if constexpr (Augmented) mean += h * h / 12 * slope.cross(w1);
        const Quaternion<Real> rho = rotation_by(Vector3<Real>(h * mean));
        const Vector3<Real> L2 = rho.conjugate() * L1;
        return {s1.t + h, (s1.q * rho).normalized(), L2.cwiseQuotient(inertia.unit)};
    }
    /// [step]
};

inline constexpr BussSpin<false> buss_2;         ///< of the two, the shorter
inline constexpr BussSpin<true> buss_augmented;  ///< with the term more

}  // namespace timestep
