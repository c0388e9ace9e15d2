#pragma once
/// \file
/// Explicit midpoint: a whole step with the rate found half a step ahead.

#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// The explicit midpoint method: the rate in the middle of the step, found by half a step of
/// explicit Euler, carries the whole step. Second order (N35).
struct Midpoint {
    static constexpr const char* name = "midpoint";  ///< for tables and keys
    static constexpr int order = 2;                  ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 2};    ///< of one step
    static constexpr bool takes_damping = true;      ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        true;  ///< on a spring: of any two lengths, in either order

    /// One step of length h, in seconds, of a State or a FirstOrder.
    template <class Model, class S>
    [[nodiscard]] S step(const Model& f, const S& state1, real_of<S> h) const {
        const auto k1 = rate(f, state1);
        const auto k2 = rate(f, advance(state1, h / 2, k1));
        return advance(state1, h, k2);
    }
};

inline constexpr Midpoint midpoint;  ///< the method as a value

}  // namespace timestep
