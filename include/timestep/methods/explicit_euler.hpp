#pragma once
/// \file
/// Explicit Euler: extrapolate from the known state.

#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// Explicit Euler (N20, N21). The forward difference (y₂ − y₁)/h stands in for the derivative at
/// the start of the step, so y₂ = y₁ + h f(t₁, y₁), whose right side is known.
struct ExplicitEuler {
    static constexpr const char* name = "explicit Euler";  ///< for tables and keys
    static constexpr int order = 1;                        ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 1};          ///< of one step
    static constexpr bool takes_damping = true;            ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        true;  ///< on a spring: of any two lengths, in either order

    /// One step of length h, in seconds.
    /// [step]
    template <class Model, class X>
    [[nodiscard]] State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        const auto& [t1, x1, v1] = state1;
        const X a1 = acceleration(model, x1, v1);
        const X x2 = x1 + h * v1;
        const X v2 = v1 + h * a1;
        return {t1 + h, x2, v2};
    }
    /// [step]

    /// One step of length h, in seconds, of a first-order system.
    template <class System, class Y>
    [[nodiscard]] FirstOrder<Y> step(const System& f, const FirstOrder<Y>& state1,
                                     real_of<Y> h) const {
        return advance(state1, h, rate(f, state1));
    }
};

inline constexpr ExplicitEuler explicit_euler;  ///< the method as a value

}  // namespace timestep
