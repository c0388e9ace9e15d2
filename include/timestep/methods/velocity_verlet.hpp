#pragma once
/// \file
/// Velocity Verlet: the positions of plain Verlet, with the velocity that belongs to them.

#include <timestep/checks.hpp>
#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// A state and its acceleration. The force at the end of a step is the force at the start of the
/// next one, so a method that keeps it evaluates the force once per step.
template <class X>
struct StateWithAcceleration {
    State<X> state;  ///< time, position and velocity
    X a;             ///< the acceleration at `state`, m/s²
};

/// Velocity Verlet (I10). The position moves as under a constant force, the velocity with the mean
/// of the forces at both ends. A one-step method: it starts by itself, and the step may change.
struct VelocityVerlet {
    static constexpr const char* name = "velocity Verlet";  ///< for tables and keys
    static constexpr int order = 2;                         ///< of the error after a whole run
    /// Of one step of a State. A step of a StateWithAcceleration evaluates the force once.
    static constexpr Cost cost{.evaluations = 2};
    static constexpr bool takes_damping = false;  ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        false;  ///< on a spring: of any two lengths, in either order

    /// One step of length h, in seconds.
    template <class Model, class X>
    [[nodiscard]] State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        return step(model, with_acceleration(model, state1), h).state;
    }

    /// One step of length h, in seconds, from a state whose acceleration is known: one evaluation
    /// of the force.
    /// [step]
    template <class Model, class X>
    [[nodiscard]] StateWithAcceleration<X> step(const Model& model,
                                                const StateWithAcceleration<X>& start,
                                                real_of<X> h) const {
        const auto& [t1, x1, v1] = start.state;
        const X& a1 = start.a;
        const X x2 = x1 + (h * v1 + h * h / 2 * a1);
        const X a2 = acceleration(model, x2);
        const X v2 = v1 + h / 2 * a1 + h / 2 * a2;
        return {{t1 + h, x2, v2}, a2};
    }
    /// [step]

    /// The state to start from, with the acceleration that `model` gives it. Call this again when
    /// the position changes other than by a step, or the force itself changes.
    template <class Model, class X>
    [[nodiscard]] StateWithAcceleration<X> with_acceleration(const Model& model,
                                                             const State<X>& state) const {
        return {state, acceleration(model, state.x)};
    }
};

inline constexpr VelocityVerlet velocity_verlet;  ///< the method as a value

}  // namespace timestep
