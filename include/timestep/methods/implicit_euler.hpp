#pragma once
/// \file
/// Implicit Euler: the new state on both sides of the equation.

#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>
#include <timestep/newton_raphson.hpp>

namespace timestep {

/// The result of a step that solves an equation.
template <class S>
struct SolvedStep {
    S state;         ///< the state at the end of the step
    bool converged;  ///< whether the equation is solved; if not, `state` is only the nearest found
};

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

    // v₂ = v₁ + h a(x₁ + h v₂, v₂). If the force is linear, the terms with v₂ go to the left:
    //     (1 − h ∂a/∂v − h² ∂a/∂x) v₂ = v₁ + h a(x₁, 0)
    // On the spring: v₂ = (v₁ − h ω² x₁) / (1 + h² ω²). For other forces Newton–Raphson finds v₂.
    /// One step of length h, in seconds, and whether its equation is solved. With steps so long
    /// that the force changes direction within one (ωh > 1 on a pendulum), Newton–Raphson may find
    /// no root.
    template <class Model, class X>
    [[nodiscard]] SolvedStep<State<X>> try_step(const Model& model, const State<X>& state1,
                                                real_of<X> h) const {
        const auto& [t1, x1, v1] = state1;
        const auto [v2, found] = new_velocity(model, x1, v1, h);
        const X x2 = x1 + h * v2;
        return {{t1 + h, x2, v2}, found};
    }

    /// One step of length h, in seconds, of a first-order system, and whether its equation is
    /// solved.
    template <class System, class Y>
    [[nodiscard]] SolvedStep<FirstOrder<Y>> try_step(const System& f, const FirstOrder<Y>& state1,
                                                     real_of<Y> h) const {
        static_assert(
            requires { f.slope_y(state1.t, state1.y); },
            "timestep: implicit methods need the system's derivative slope_y(t, y)");
        const auto t2 = state1.t + h;
        const Y y1 = state1.y;
        const auto [y2, found] = newton_raphson(
            y1, [&](const Y& y) -> Y { return y - y1 - h * f(t2, y); },
            [&](const Y& y) { return implicit_matrix(h, f.slope_y(t2, y), real_of<Y>(0)); });
        return {{t2, y2}, found};
    }

    /// One step of length h, in seconds. If its equation is not solved, the step ends at the
    /// nearest state found; try_step() reports that.
    template <class Model, class X>
    [[nodiscard]] State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        return try_step(model, state1, h).state;
    }

    /// One step of length h, in seconds, of a first-order system. If its equation is not solved,
    /// the step ends at the nearest state found; try_step() reports that.
    template <class System, class Y>
    [[nodiscard]] FirstOrder<Y> step(const System& f, const FirstOrder<Y>& state1,
                                     real_of<Y> h) const {
        return try_step(f, state1, h).state;
    }

    /// Refuses a step for which h², or the step's divisor 1 − h ∂a/∂v − h² ∂a/∂x of a linear force,
    /// is too large for a number.
    template <class Model, class X>
    void check_step(const Model& model, const State<X>& s, real_of<X> h) const {
        bool good = is_finite(h * h);
        if constexpr (LinearForce<Model, X>)
            good = good && is_finite(implicit_matrix(h, slope_v(model, s.x, s.v),
                                                     slope_x(model, s.x, s.v)));
        if (!good) refuse_step(h);
    }

    /// Refuses a step for which h ∂f/∂y at the start is too large for a number. (A slope that is
    /// itself infinite or NaN, as that of √y at zero, is not the step's fault.)
    template <class System, class Y>
    void check_step(const System& f, const FirstOrder<Y>& s, real_of<Y> h) const {
        if constexpr (requires { f.slope_y(s.t, s.y); }) {
            const auto& slope = f.slope_y(s.t, s.y);
            if (is_finite(slope) && !is_finite(implicit_matrix(h, slope, real_of<Y>(0))))
                refuse_step(h);
        }
    }

private:
    template <class Real>
    static void refuse_step(Real h) {
        refuse("step", h, "so short that its square, and that times the force's slope, is finite");
    }

    // A force that is linear in x and v: one solve.
    /// [linear]
    template <class Model, class X>
    requires LinearForce<Model, X> Root<X> new_velocity(const Model& model, const X& x1,
                                                        const X& v1, real_of<X> h)
    const {
        const auto matrix = implicit_matrix(h, slope_v(model, x1, v1), slope_x(model, x1, v1));
        return {solve(matrix, X(v1 + h * acceleration(model, x1, zero<X>()))), true};
    }
    /// [linear]

    // Any other smooth force: the root of what is missing in v₂ = v₁ + h a(x₁ + h v₂, v₂).
    /// [newton]
    template <class Model, class X>
    Root<X> new_velocity(const Model& model, const X& x1, const X& v1, real_of<X> h) const {
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
        return newton_raphson(v1, missing, slope);
    }
    /// [newton]
};

inline constexpr ImplicitEuler implicit_euler;  ///< the method as a value

}  // namespace timestep
