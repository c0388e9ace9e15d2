#pragma once
/// \file
/// Magnus and Taylor: one rotation a step, of order four, and no equation to solve.

#include <timestep/rigid/spin_state.hpp>

namespace timestep {

/// A body with the spin ω(t) turns over a step by one rotation exp(Ω). Magnus (1954) has Ω as a
/// series in integrals of ω, of which order four needs two; Taylor's series puts in ω and its
/// derivatives, which Euler's equations give. Explicit; |L| stays, as L is turned, too. The energy
/// is kept to order four.
struct MagnusTaylor {
    static constexpr const char* name = "Magnus-Taylor 4";  ///< for tables and keys
    static constexpr int order = 4;                         ///< of the error after a whole run

    // ω̇ is −a (yz, zx, xy); the next two derivatives are that by the product rule.
    /// One step of `h` seconds.
    /// [step]
    template <class Real>
    TIMESTEP_INLINE
    SpinState<Real> step(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s1,
                         Real h) const {
        using V = Vector3<Real>;
        const auto torque = [&](const V& u, const V& v) -> V {  // both sides of the product rule
            const V pairs(u.y() * v.z() + u.z() * v.y(), u.z() * v.x() + u.x() * v.z(),
                          u.x() * v.y() + u.y() * v.x());
            return -inertia.ratio.cwiseProduct(pairs);
        };
        const V w = h * s1.omega;  // hω, h²ω̇, h³ω̈, h⁴ω⃛
        const V w1 = torque(w, w) / 2, w2 = torque(w, w1), w3 = torque(w, w2) + torque(w1, w1);
        const V turn = w + w1 / 2 + w2 / 6 + w3 / 24 + w.cross(w1) / 12 + w.cross(w2) / 24;
        const Quaternion<Real> rho = turn_by(turn);
        const V L = rho.conjugate() * V(inertia.unit.cwiseProduct(s1.omega));
        return {s1.t + h, (s1.q * rho).normalized(), L.cwiseQuotient(inertia.unit)};
    }
    /// [step]
};

inline constexpr MagnusTaylor magnus_taylor;  ///< the method as a value

}  // namespace timestep
