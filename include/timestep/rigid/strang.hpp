#pragma once
/// \file
/// One axis after another: a whole-body step that keeps |L| and solves no equation.

#include <timestep/rigid/axis_spin.hpp>
#include <timestep/rigid/spin_state.hpp>

namespace timestep {

/// The energy is a sum of three parts, ½ L₁²/I₁ + ½ L₂²/I₂ + ½ L₃²/I₃. With one part alone the
/// motion is a steady rotation about that axis, by the angle h Lᵢ/Iᵢ. A step takes them in the
/// order 1, 2, 3, 2, 1: half a step of each, and a whole step of the middle one (McLachlan 1993,
/// Reich 1994).
///
/// Order two. Every part is a rotation, so |L| stays for any step. The energy oscillates and does
/// not drift while h|ω| is small, and it is at most |L|²/2I of the least moment. A step of −h
/// undoes a step of h.
struct Strang {
    static constexpr const char* name = "Strang splitting";  ///< for tables and keys
    static constexpr int order = 2;                          ///< of the error after a whole run

    /// One step of `h` seconds.
    /// [step]
    template <class Real>
    TIMESTEP_INLINE SpinState<Real> step(const PrincipalInertia<Real>& inertia,
                                         const SpinState<Real>& s1, Real h) const noexcept {
        const Vector3<Real>& U = inertia.unit;
        AxisSpin<Real> body{s1.q, U.cwiseProduct(s1.omega)};
        body.spin(0, h / 2 * (body.L[0] / U[0]));
        body.spin(1, h / 2 * (body.L[1] / U[1]));
        body.spin(2, h * (body.L[2] / U[2]));
        body.spin(1, h / 2 * (body.L[1] / U[1]));
        body.spin(0, h / 2 * (body.L[0] / U[0]));
        return {s1.t + h, over_its_length(body.q), body.L.cwiseQuotient(U)};
    }
    /// [step]
};

inline constexpr Strang strang;  ///< the method as a value

}  // namespace timestep
