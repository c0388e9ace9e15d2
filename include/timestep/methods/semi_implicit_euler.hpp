#pragma once
/// \file
/// Semi-implicit Euler: the first choice for games.

#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// Semi-implicit, or symplectic, Euler (N29). The velocity is extrapolated as in explicit Euler,
/// but the position moves with the NEW velocity. It differs by one character, costs as much, and a
/// spring does not blow up while ωh < 2.
struct SemiImplicitEuler {
    static constexpr const char* name = "semi-implicit Euler";  ///< for tables and keys
    static constexpr int order = 1;                             ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 1};               ///< of one step
    static constexpr bool takes_damping = true;  ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        false;  ///< on a spring: of any two lengths, in either order

    /// One step of length h, in seconds.
    /// [step]
    template <class Model, class X>
    [[nodiscard]] State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        const auto& [t1, x1, v1] = state1;
        const X v2 = v1 + h * acceleration(model, x1, v1);
        const X x2 = x1 + h * v2;
        return {t1 + h, x2, v2};
    }
    /// [step]
};

inline constexpr SemiImplicitEuler semi_implicit_euler;  ///< the method as a value

}  // namespace timestep
