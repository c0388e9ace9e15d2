#pragma once
/// \file
/// A gyroscopic solver, with the orientation stepped by the mean spin: a method for the whole body.

#include <algorithm>

#include <timestep/rigid/spin_state.hpp>

namespace timestep {

/// `Solver` computes the new ω; the mean of the old and the new ω, in body coordinates, rotates the
/// orientation. A solver of order two keeps its order in the orientation too. With the new ω alone,
/// as in the talk (N42), the orientation of a tumbling body has order one with every solver.
template <class Solver>
struct Tumble {
    static constexpr const char* name = Solver::name;         ///< for tables and keys
    static constexpr int order = std::min(Solver::order, 2);  ///< of the error after a whole run

    /// One step of `h` seconds.
    /// [step]
    template <class Inertia, class Real>
    TIMESTEP_INLINE SpinState<Real> step(const Inertia& inertia, const SpinState<Real>& s1,
                                         Real h) const {
        static_assert(detail::one_real<Inertia, Real>,
                      "timestep: the inertia and the state hold one kind of number: both float, or "
                      "both double");
        const Vector3<Real> omega2 = Solver{}.step(inertia, s1.omega, h);
        const Vector3<Real> mean = s1.omega / 2 + omega2 / 2;
        return {s1.t + h, rotated_in_body(s1.q, mean, h), omega2};
    }
    /// [step]
};

template <class Solver>
inline constexpr Tumble<Solver> tumble{};  ///< the method as a value

}  // namespace timestep
