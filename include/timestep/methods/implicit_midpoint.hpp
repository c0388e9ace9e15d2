#pragma once
/// \file
/// Implicit midpoint: the rate in the middle of the step, which is not known yet.

#include <timestep/methods/implicit_euler.hpp>

namespace timestep {

/// The implicit midpoint rule: y₂ = y₁ + h f((y₁ + y₂)/2). Second order, and on the undamped spring
/// it keeps the energy for every step size (N35).
///
/// The middle m = (y₁ + y₂)/2 obeys m = y₁ + (h/2) f(m): implicit Euler over half the step. The end
/// is as far from the middle as the start is: y₂ = 2m − y₁.
struct ImplicitMidpoint {
    static constexpr const char* name = "implicit midpoint";    ///< for tables and keys
    static constexpr int order = 2;                             ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 1, .solves = 1};  ///< of one step
    static constexpr bool takes_damping = true;  ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        true;  ///< on a spring: of any two lengths, in either order

    /// One step of length h, in seconds, and whether its equation is solved.
    template <class Model, class X>
    [[nodiscard]] SolvedStep<State<X>> try_step(const Model& model, const State<X>& state1,
                                                real_of<X> h) const {
        const auto [middle, converged] = implicit_euler.try_step(model, state1, h / 2);
        return {{state1.t + h, 2 * middle.x - state1.x, 2 * middle.v - state1.v}, converged};
    }

    /// One step of length h, in seconds, of a first-order system, and whether its equation is
    /// solved.
    template <class System, class Y>
    [[nodiscard]] SolvedStep<FirstOrder<Y>> try_step(const System& f, const FirstOrder<Y>& state1,
                                                     real_of<Y> h) const {
        const auto [middle, converged] = implicit_euler.try_step(f, state1, h / 2);
        return {{state1.t + h, 2 * middle.y - state1.y}, converged};
    }

    /// One step of length h, in seconds; try_step() also reports whether its equation is solved.
    template <class Model, class X>
    [[nodiscard]] State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        return try_step(model, state1, h).state;
    }

    /// One step of length h, in seconds, of a first-order system; try_step() also reports whether
    /// its equation is solved.
    template <class System, class Y>
    [[nodiscard]] FirstOrder<Y> step(const System& f, const FirstOrder<Y>& state1,
                                     real_of<Y> h) const {
        return try_step(f, state1, h).state;
    }

    /// Refuses a step h that implicit Euler refuses.
    template <class Model, class S>
    void check_step(const Model& model, const S& s, real_of<S> h) const {
        implicit_euler.check_step(model, s, h);
    }
};

inline constexpr ImplicitMidpoint implicit_midpoint;  ///< the method as a value

}  // namespace timestep
