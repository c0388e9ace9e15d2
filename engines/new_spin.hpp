#pragma once
/// \file
/// What engines do with the spin that their solver finds.

#include <timestep/rigid/spin_state.hpp>

namespace timestep {

/// A solver for ω, and the orientation turned by the NEW ω for the whole step, as every engine of the
/// appendix does it (semi-implicit Euler). The orientation has order one, whatever the solver.
template <class Solver>
struct NewSpin {
    static constexpr const char* name = Solver::name;        ///< for tables and keys
    static constexpr int order = Solver::order < 1 ? 0 : 1;  ///< of the error after a whole run

    /// One step of `h` seconds.
    template <class Inertia, class Real>
    TIMESTEP_INLINE SpinState<Real> step(const Inertia& inertia, const SpinState<Real>& s1, Real h) const {
        const Vector3<Real> omega2 = Solver{}.step(inertia, s1.omega, h);
        return {s1.t + h, rotated_in_body(s1.q, omega2, h), omega2};
    }
};

}  // namespace timestep
