#pragma once
/// \file
/// Implicit midpoint on the whole body: energy and angular momentum kept.

#include <timestep/gyroscopic/converged_gyroscopic.hpp>
#include <timestep/rigid/spin_state.hpp>

namespace timestep {

/// I(ω₂ − ω₁) + h m × Im = 0 with m = ½(ω₁ + ω₂), and the orientation turned by m.
///
/// Order two, for any step. The torque is at right angles to m and to Im: with 2m = ω₁ + ω₂ the
/// first says that the energies are equal, the second that |L| is. The orientation turns by the very
/// Cayley transform that the equation holds for L, so L stays in the world, too. Its price is the
/// equation: several Newton steps.
struct MidpointSpin {
    static constexpr const char* name = "implicit midpoint";  ///< for tables and keys
    static constexpr int order = 2;                           ///< of the error after a whole run

    // With ω₂ = 2m − ω₁ the equation is I(m − ω₁) + h/2 m × Im = 0: half a step of implicit Euler.
    /// One step of `h` seconds. Calls `iterated()` after each Newton step.
    /// [step]
    template <class Real, class Iterated>
    SpinState<Real> step(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s1, Real h,
                         const Iterated& iterated) const {
        const Vector3<Real> m = converged_gyroscopic.step(inertia, s1.omega, h / 2, iterated);
        return {s1.t + h, rotated_in_body(s1.q, m, h), 2 * m - s1.omega};
    }
    /// [step]
    /// The same, and nobody counts.
    template <class Real>
    SpinState<Real> step(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s1, Real h) const {
        return step(inertia, s1, h, [] {});
    }
};

inline constexpr MidpointSpin midpoint_spin;  ///< the method as a value

}  // namespace timestep
