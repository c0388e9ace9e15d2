#pragma once
/// \file
/// The classical Runge–Kutta method of order four.

#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// RK4 evaluates the rate at the start, twice in the middle and at the end, and weights the four as
/// Simpson's rule does. Fourth order while the force is smooth (N35, N36); the course's reference
/// where no exact solution is known (I03).
struct RungeKutta4 {
    static constexpr const char* name = "Runge-Kutta 4";  ///< for tables and keys
    static constexpr int order = 4;                       ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 4};         ///< of one step
    static constexpr bool takes_damping = true;           ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        true;  ///< on a spring: of any two lengths, in either order

    /// One step of length h, in seconds, of a State or a FirstOrder.
    template <class Model, class S>
    [[nodiscard]] S step(const Model& f, const S& state1, real_of<S> h) const {
        // Each rate is added with Simpson's weight as soon as it is known: no sum waits for the
        // end.
        const auto k1 = rate(f, state1);
        S state2 = advance(state1, h / 6, k1);
        const auto k2 = rate(f, advance(state1, h / 2, k1));
        const auto k3 = rate(f, advance(state1, h / 2, k2));
        state2 = advance(state2, h / 3, k2 + k3);
        const auto k4 = rate(f, advance(state1, h, k3));
        state2 = advance(state2, h / 6, k4);
        state2.t = state1.t + h;  // exactly, where a sum of parts would round
        return state2;
    }
};

inline constexpr RungeKutta4 runge_kutta_4;  ///< the method as a value

}  // namespace timestep
