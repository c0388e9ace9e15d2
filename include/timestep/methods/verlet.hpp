#pragma once
/// \file
/// Störmer–Verlet: two positions and no velocity.

#include <timestep/checks.hpp>
#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// Plain Verlet (I07, I08). Semi-implicit Euler over two steps,
///     x₁ = x₀ + h v₁,   v₂ = v₁ + h a(x₁),   x₂ = x₁ + h v₂,
/// with the velocities eliminated: x₂ − x₁ = h v₂ = (x₁ − x₀) + h² a(x₁). What is left steps from
/// two positions, so the force may depend on the position alone.
///
/// No step reads the `v` of the states. It is computed for output only: (x₂ − x₁)/h is the velocity
/// in the middle of the step, and half a step at a(x₁) carries it to the end, within O(h²).
struct Verlet {
    static constexpr const char* name = "Verlet";  ///< for tables and keys
    static constexpr int order = 2;                ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 1};  ///< of one step
    static constexpr bool takes_damping = false;   ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        false;  ///< on a spring: of any two lengths, in either order

    static constexpr bool computes_velocity_anew = true;  ///< no step reads the velocity

    /// The first step, of length h in seconds, from one state alone: the Taylor series as far as
    /// the force is known. Without its last term the whole run is of order one (I10).
    /// [start]
    template <class Model, class X>
    [[nodiscard]] State<X> start(const Model& model, const State<X>& state0, real_of<X> h) const {
        const auto& [t0, x0, v0] = state0;
        const X a0 = acceleration(model, x0);
        const X x1 = x0 + h * v0 + h * h / 2 * a0;
        return {t0 + h, x1, v0 + h * a0};
    }
    /// [start]

    /// One step of length h, in seconds, on from `state1`; `state0` is h before it.
    /// [step]
    template <class Model, class X>
    [[nodiscard]] State<X> step(const Model& model, const State<X>& state0, const State<X>& state1,
                                real_of<X> h) const {
        const X& x0 = state0.x;
        const X& x1 = state1.x;
        const X a1 = acceleration(model, x1);
        const X x2 = 2 * x1 - x0 + h * h * a1;
        return {state1.t + h, x2, (x2 - x1) / h + h / 2 * a1};
    }
    /// [step]

    /// A step of length `h2` after one of `h1`, both in seconds, by the usual repair: the last
    /// displacement is scaled to the new step. Order one when the step keeps changing (I10).
    template <class Model, class X>
    [[nodiscard]] State<X> scaled_step(const Model& model, const State<X>& state0,
                                       const State<X>& state1, real_of<X> h1, real_of<X> h2) const {
        const X& x1 = state1.x;
        const X a1 = acceleration(model, x1);
        const X drift = (x1 - state0.x) * (h2 / h1);
        const X x2 = x1 + drift + h2 * h2 * a1;
        return {state1.t + h2, x2, (x2 - x1) / h2 + h2 / 2 * a1};
    }

    // (x₁ − x₀)/h₁ is the velocity h₁/2 before x₁, and (x₂ − x₁)/h₂ the velocity h₂/2 after it. The
    // force acts for the time between the two, (h₁ + h₂)/2.
    /// A step of length `h2` after one of `h1`, both in seconds, corrected for the time that the
    /// force acts. Order two for any sequence of steps (I10).
    /// [corrected]
    template <class Model, class X>
    [[nodiscard]] State<X> corrected_step(const Model& model, const State<X>& state0,
                                          const State<X>& state1, real_of<X> h1,
                                          real_of<X> h2) const {
        const X& x1 = state1.x;
        const X a1 = acceleration(model, x1);
        const X drift = (x1 - state0.x) * (h2 / h1);
        const X x2 = x1 + drift + h2 * (h1 + h2) / 2 * a1;
        return {state1.t + h2, x2, (x2 - x1) / h2 + h2 / 2 * a1};
    }
    /// [corrected]
};

inline constexpr Verlet verlet;  ///< the method as a value

}  // namespace timestep
