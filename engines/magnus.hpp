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

    // ω̇ is −a (yz, zx, xy); the next two derivatives come by the product rule. Below, w, w1, w2
    // and w3 are hω, h²ω̇ and so on.
    /// One step of `h` seconds.
    /// [step]
    template <class Real>
    TIMESTEP_INLINE SpinState<Real> step(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s1,
                                         Real h) const {
        using V = Vector3<Real>;
        const V &a = inertia.ratio, &U = inertia.unit;
        const auto both = [&](const V& u, const V& v) -> V {
            const V pairs(u.y() * v.z() + u.z() * v.y(), u.z() * v.x() + u.x() * v.z(), u.x() * v.y() + u.y() * v.x());
            return -a.cwiseProduct(pairs);
        };
        const V w = h * s1.omega;
        const V w1 = both(w, w) / 2, w2 = both(w, w1);
        const V w3 = both(w, w2) + both(w1, w1);
        const V turn = w + w1 / 2 + w2 / 6 + w3 / 24 + w.cross(w1) / 12 + w.cross(w2) / 24;
        const Quaternion<Real> rho = rotation_by(turn);
        const V L = rho.conjugate() * V(U.cwiseProduct(s1.omega));
        return {s1.t + h, (s1.q * rho).normalized(), L.cwiseQuotient(U)};
    }
    /// [step]
};

inline constexpr MagnusTaylor magnus_taylor;  ///< the method as a value

}  // namespace timestep
