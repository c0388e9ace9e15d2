#pragma once
/// \file
/// Implicit Euler: the new state on both sides of the equation.

#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>
#include <timestep/newton_raphson.hpp>

namespace timestep {

/// Implicit Euler (N26). The backward difference (y₂ − y₁)/h stands in for the derivative at the
/// END of the step: y₂ = y₁ + h f(t₂, y₂) has to be solved for y₂. It never blows up on a spring,
/// and it damps what should not be damped (N27).
struct ImplicitEuler {
    static constexpr const char* name = "implicit Euler";       ///< for tables and keys
    static constexpr int order = 1;                             ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 1, .solves = 1};  ///< of one step
    static constexpr bool takes_damping = true;  ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        true;  ///< on a spring: of any two lengths, in either order

    // v₂ = v₁ + h a(x₁ + h v₂, v₂). Where the force is linear, the terms with v₂ go to the left:
    //     (1 − h ∂a/∂v − h² ∂a/∂x) v₂ = v₁ + h a(x₁, 0)
    // On the spring: v₂ = (v₁ − h ω² x₁) / (1 + h² ω²). Elsewhere Newton–Raphson finds v₂.
    /// One step of length h.
    /// [step]
    template <class Model, class X>
    State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        const auto& [t1, x1, v1] = state1;
        const X v2 = new_velocity(model, x1, v1, h);
        const X x2 = x1 + h * v2;
        return {t1 + h, x2, v2};
    }
    /// [step]

    /// One step of length h of a first-order system.
    /// [first order]
    template <class System, class Y>
    FirstOrder<Y> step(const System& f, const FirstOrder<Y>& state1, real_of<Y> h) const {
        static_assert(
            requires { f.slope_y(state1.t, state1.y); },
            "timestep: implicit methods need the system's derivative slope_y(t, y)");
        const auto t2 = state1.t + h;
        const Y y1 = state1.y;
        const Y y2 =
            newton_raphson(
                y1, [&](const Y& y) -> Y { return y - y1 - h * f(t2, y); },
                [&](const Y& y) { return implicit_matrix(h, f.slope_y(t2, y), real_of<Y>(0)); })
                .x;
        return {t2, y2};
    }
    /// [first order]

private:
    // A force that is linear in x and v: one solve.
    /// [linear]
    template <class Model, class X>
    requires LinearForce<Model, X> X new_velocity(const Model& model, const X& x1, const X& v1,
                                                  real_of<X> h)
    const {
        const auto matrix = implicit_matrix(h, slope_v(model, x1, v1), slope_x(model, x1, v1));
        return solve(matrix, X(v1 + h * acceleration(model, x1, zero<X>())));
    }
    /// [linear]

    // Any other smooth force: the root of what is missing in v₂ = v₁ + h a(x₁ + h v₂, v₂). With
    // steps so long that what is missing rises and falls with v₂, Newton–Raphson may not find it,
    // and the step goes on with what is nearest: who has to know puts v₂ in once more.
    /// [newton]
    template <class Model, class X>
    X new_velocity(const Model& model, const X& x1, const X& v1, real_of<X> h) const {
        static_assert(SmoothForce<Model, X>,
                      "timestep: implicit methods need the force's derivatives slope_x and "
                      "slope_v");
        const auto missing = [&](const X& v2) -> X {
            const X x2 = x1 + h * v2;
            return v2 - v1 - h * acceleration(model, x2, v2);
        };
        const auto slope = [&](const X& v2) {
            const X x2 = x1 + h * v2;
            return implicit_matrix(h, slope_v(model, x2, v2), slope_x(model, x2, v2));
        };
        return newton_raphson(v1, missing, slope).x;
    }
    /// [newton]
};

inline constexpr ImplicitEuler implicit_euler;  ///< the method as a value

}  // namespace timestep
