#pragma once
/// \file
/// The constant-acceleration step: the force is taken as constant over the step.

#include <timestep/checks.hpp>
#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// The constant-acceleration step, which the talk calls Newton (I09). Each step is a piece of a
/// parabola, so the step is exact for projectiles with every h.
///
/// On an undamped spring the step has determinant 1 + (ωh)²/2 and trace 2 − (ωh)²/2. Up to ωh = 4
/// its eigenvalues are a pair with |λ| = √(1 + (ωh)²/2). Beyond, they are real, and the larger one
/// grows faster still. The step blows up for every ω > 0 and every h.
struct ConstantAcceleration {
    static constexpr const char* name = "constant acceleration";  ///< for tables and keys
    static constexpr int order = 1;                ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 1};  ///< of one step
    static constexpr bool takes_damping = true;    ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        false;  ///< on a spring: of any two lengths, in either order

    /// One step of length h, in seconds.
    template <class Model, class X>
    [[nodiscard]] State<X> step(const Model& model, const State<X>& state1, real_of<X> h) const {
        const auto& [t1, x1, v1] = state1;
        const X a1 = acceleration(model, x1, v1);
        const X x2 = x1 + h * v1 + h * h / 2 * a1;
        const X v2 = v1 + h * a1;
        return {t1 + h, x2, v2};
    }
};

inline constexpr ConstantAcceleration constant_acceleration;  ///< the method as a value

}  // namespace timestep
