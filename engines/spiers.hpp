#pragma once
/// \file
/// Ben Spiers's turns (2026), one of them proposed for Avian: a body is taken for a symmetric one, anew in each step.

#include "new_spin.hpp"

namespace timestep {

/// Within a step L turns in the body as that of a symmetric body would: about Ω = ω − J′L, where J′ is one over the
/// two equal moments. Jolt's tangent is the first term of such a turn, for any J′, since L × L = 0. This J′ is the one
/// for which the energy's second derivative vanishes: k·I⁻¹k / k·k with k = ω × L. Of two equal moments it is one over
/// those, and the step exact.
template <class Real>
struct SymmetricGuess {
    Vector3<Real> L;      ///< the angular momentum, in the body
    Vector3<Real> about;  ///< Ω, about which the body turns under it
    Real inverse;         ///< J′; the rest of the turn is J′L, about L itself

    /// Of moments of any unit; `omega` in body coordinates, rad/s.
    /// [axis]
    TIMESTEP_INLINE
    SymmetricGuess(const PrincipalInertia<Real>& inertia, const Vector3<Real>& omega)
        : L(inertia.unit.cwiseProduct(omega)) {
        const Vector3<Real> k = omega.cross(L);
        const Real k2 = k.dot(k);
        inverse = k2 > 0 ? k.cwiseQuotient(inertia.unit).dot(k) / k2 : Real(0);
        about = omega - inverse * L;
    }
    /// [axis]
};

/// The step as engines can take it, a new ω: L₂ is L₁ turned by −hΩ, and ω₂ = I⁻¹L₂. Pull request 993 of Avian.
struct AvianGyroscopic {
    static constexpr const char* name = "Avian proposed";  ///< for tables and keys
    static constexpr int order = 1;                        ///< of the error after a whole run

    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia, const Vector3<Real>& omega,
                                       Real h) const {
        const SymmetricGuess<Real> guess(inertia, omega);
        const Vector3<Real> turn = h * guess.about;
        return (rotation_by(turn).conjugate() * guess.L).cwiseQuotient(inertia.unit);
    }
};

/// The whole body.
struct AvianSpin : NewSpin<AvianGyroscopic> {};

/// Both turns of the symmetric body, so that L stays in the world: by hΩ, and then by hJ′L.
struct SpiersSpin {
    static constexpr const char* name = "Spiers";  ///< for tables and keys
    static constexpr int order = 1;                ///< of the error after a whole run

    /// One step of `h` seconds.
    /// [whole]
    template <class Real>
    TIMESTEP_INLINE SpinState<Real> step(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s1,
                                         Real h) const {
        const SymmetricGuess<Real> guess(inertia, s1.omega);
        const Quaternion<Real> first = rotation_by(Vector3<Real>(h * guess.about));
        const Vector3<Real> L2 = first.conjugate() * guess.L;
        const Quaternion<Real> last = rotation_by(Vector3<Real>(h * guess.inverse * L2));
        return {s1.t + h, (s1.q * first * last).normalized(), L2.cwiseQuotient(inertia.unit)};
    }
    /// [whole]
};

inline constexpr AvianSpin avian_spin;    ///< the method as a value
inline constexpr SpiersSpin spiers_spin;  ///< the method as a value

}  // namespace timestep
