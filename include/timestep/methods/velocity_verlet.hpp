#pragma once
/// \file
/// Velocity Verlet: the positions of plain Verlet, with the velocity that belongs to them.

#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// Velocity Verlet (I10). The position moves as under a constant force, the velocity with the mean
/// of the forces at both ends. A one-step method: it starts by itself, and the step may change.
struct VelocityVerlet {
    static constexpr const char* name = "velocity Verlet";  ///< for tables and keys
    static constexpr int order = 2;                         ///< of the error after a whole run
    /// Of one step. The force at the end is the next step's force at the start: who keeps it pays
    /// one.
    static constexpr Cost cost{.evaluations = 2};
    static constexpr bool takes_damping = false;  ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        false;  ///< on a spring: of any two lengths, in either order

    /// One step of length h.
    /// [step]
    template <class Model, class X>
    State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        const auto& [t1, x1, v1] = state1;
        const X a1 = acceleration(model, x1);
        const X x2 = x1 + (h * v1 + h * h / 2 * a1);
        const X a2 = acceleration(model, x2);
        const X v2 = v1 + h / 2 * a1 + h / 2 * a2;
        return {t1 + h, x2, v2};
    }
    /// [step]
};

inline constexpr VelocityVerlet velocity_verlet;  ///< the method as a value

}  // namespace timestep
