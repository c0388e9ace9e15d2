#pragma once
/// \file
/// Implicit midpoint: the rate in the middle of the step, where nobody has been yet.

#include <timestep/methods/implicit_euler.hpp>

namespace timestep {

/// The implicit midpoint rule: y₂ = y₁ + h f((y₁ + y₂)/2). Second order, and on the undamped spring
/// it keeps the energy for every step size (N35).
///
/// The middle m = (y₁ + y₂)/2 obeys m = y₁ + (h/2) f(m): implicit Euler over half the step. From
/// the middle it is as far again to the end: y₂ = 2m − y₁.
struct ImplicitMidpoint {
    static constexpr const char* name = "implicit midpoint";    ///< for tables and keys
    static constexpr int order = 2;                             ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 1, .solves = 1};  ///< of one step
    static constexpr bool takes_damping = true;  ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        true;  ///< on a spring: of any two lengths, in either order

    /// One step of length h.
    /// [step]
    template <class Model, class X>
    State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        const State<X> middle = implicit_euler.step(model, state1, h / 2);
        return {state1.t + h, 2 * middle.x - state1.x, 2 * middle.v - state1.v};
    }
    /// [step]

    /// The same for a first-order system.
    template <class System, class Y>
    FirstOrder<Y> step(const System& f, const FirstOrder<Y>& state1, real_of<Y> h) const {
        const FirstOrder<Y> middle = implicit_euler.step(f, state1, h / 2);
        return {state1.t + h, 2 * middle.y - state1.y};
    }
};

inline constexpr ImplicitMidpoint implicit_midpoint;  ///< the method as a value

}  // namespace timestep
