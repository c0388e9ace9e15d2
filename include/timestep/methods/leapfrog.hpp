#pragma once
/// \file
/// Leapfrog: kick, drift, kick.

#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// Leapfrog (I10). The velocity takes half a step, the position a whole step, and the velocity its
/// other half step. The two half kicks of neighbouring steps make one whole kick: velocities are
/// known in the middle of the steps and positions at their ends, each leaping over the other. This
/// is semi-implicit Euler with a velocity half a step late, and velocity Verlet in another order.
struct Leapfrog {
    static constexpr const char* name = "leapfrog";  ///< for tables and keys
    static constexpr int order = 2;                  ///< of the error after a whole run
    /// Of one step. A loop that joins the half kicks of neighbouring steps needs one evaluation per
    /// step, as does velocity Verlet with a StateWithAcceleration.
    static constexpr Cost cost{.evaluations = 2};
    static constexpr bool takes_damping = false;  ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        false;  ///< on a spring: of any two lengths, in either order

    /// One step of length h, in seconds.
    /// [step]
    template <class Model, class X>
    [[nodiscard]] State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
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
