#pragma once
/// \file
/// Semi-implicit Euler that damps the new velocity.

#include <timestep/checks.hpp>
#include <timestep/forces.hpp>
#include <timestep/linear_solve.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// Semi-implicit Euler with the damping taken at the NEW velocity (N25). The spring pulls from the
/// old position as before; the damper is implicit, which costs one division:
///     v₂ = v₁ + h a(x₁, v₂)   ⇒   (1 − h ∂a/∂v) v₂ = v₁ + h a(x₁, 0)
/// The force may depend on the position in any way, as long as ∂a/∂v is the same everywhere. More
/// damping makes the longest stable step longer; damping taken at the old velocity makes it
/// shorter.
struct SemiImplicitEulerNewDamping {
    static constexpr const char* name =
        "semi-implicit Euler, new damping";                     ///< for tables and keys
    static constexpr int order = 1;                             ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 1, .solves = 1};  ///< of one step
    static constexpr bool takes_damping = true;  ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        false;  ///< on a spring: of any two lengths, in either order

    /// One step of length h, in seconds.
    /// [step]
    template <class Model, class X>
    [[nodiscard]] State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        static_assert(LinearDamping<Model, X>,
                      "timestep: damping at the new velocity needs a force that is linear in the "
                      "velocity, with slope_v()");
        const auto& [t1, x1, v1] = state1;
        const X v2 = solve(implicit_matrix(h, slope_v(model, x1, v1), real_of<X>(0)),
                           X(v1 + h * acceleration(model, x1, zero<X>())));
        const X x2 = x1 + h * v2;
        return {t1 + h, x2, v2};
    }
    /// [step]

    /// Refuses a step for which the step's divisor 1 − h ∂a/∂v is too large for a number.
    template <class Model, class X>
    void check_step(const Model& model, const State<X>& s, real_of<X> h) const {
        if constexpr (LinearDamping<Model, X>)
            if (!is_finite(implicit_matrix(h, slope_v(model, s.x, s.v), real_of<X>(0))))
                refuse("step", h, "so short that it times the force's slope is finite");
    }
};

inline constexpr SemiImplicitEulerNewDamping
    semi_implicit_euler_new_damping;  ///< the method as a value

}  // namespace timestep
