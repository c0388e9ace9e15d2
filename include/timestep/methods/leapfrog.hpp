#pragma once
/// \file
/// Leapfrog: kick, drift, kick.

#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// Leapfrog (I10). Half a step for the velocity, a whole one for the position, the other half for
/// the velocity. Two half kicks of neighbouring steps make one whole: velocities in the middle of
/// the steps, positions at their ends, each leaping over the other. That is semi-implicit Euler
/// with a velocity half a step late, and it is velocity Verlet written in another order.
struct Leapfrog {
    static constexpr const char* name = "leapfrog";  ///< for tables and keys
    static constexpr int order = 2;                  ///< of the error after a whole run
    /// Of one step. Who joins the half kicks of neighbouring steps pays one.
    static constexpr Cost cost{.evaluations = 2};
    static constexpr bool takes_damping = false;  ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        false;  ///< on a spring: of any two lengths, in either order

    /// One step of length h.
    /// [step]
    template <class Model, class X>
    State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        const auto& [t1, x1, v1] = state1;
        const X v_middle = v1 + h / 2 * acceleration(model, x1);
        const X x2 = x1 + h * v_middle;
        const X v2 = v_middle + h / 2 * acceleration(model, x2);
        return {t1 + h, x2, v2};
    }
    /// [step]
};

inline constexpr Leapfrog leapfrog;  ///< the method as a value

}  // namespace timestep
