#pragma once
/// \file
/// Explicit Euler on the gyroscopic torque: what engines did first.

#include <timestep/gyroscopic/explicit_gyroscopic.hpp>

#include "new_spin.hpp"

namespace timestep {

/// ω₂ = ω₁ − h I⁻¹(ω₁ × Iω₁). Keeps nothing: energy and |L| grow, and the body blows up.
struct ExplicitSpin : NewSpin<ExplicitGyroscopic> {
    static constexpr const char* name = "explicit Euler";  ///< for tables and keys
};

inline constexpr ExplicitSpin explicit_spin;  ///< the method as a value

}  // namespace timestep
