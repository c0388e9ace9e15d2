#pragma once
/// \file
/// Heun's method: predict, then correct.

#include <timestep/forces.hpp>
#include <timestep/methods/cost.hpp>

namespace timestep {

/// Heun's method, the simplest predictor–corrector: explicit Euler predicts the end of the step,
/// then the mean of the rates at both ends carries it. Second order (N35).
struct Heun {
    static constexpr const char* name = "Heun";    ///< for tables and keys
    static constexpr int order = 2;                ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 2};  ///< of one step
    static constexpr bool takes_damping = true;    ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        true;  ///< on a spring: of any two lengths, in either order

    /// One step of length h, in seconds, of a State or a FirstOrder.
    template <class Model, class S>
    [[nodiscard]] S step(const Model& f, const S& state1, real_of<S> h) const {
        const auto k1 = rate(f, state1);
        const auto k2 = rate(f, advance(state1, h, k1));
        return advance(state1, h, (k1 + k2) / 2);
    }
};

inline constexpr Heun heun;  ///< the method as a value

}  // namespace timestep
