#pragma once
/// \file
/// Godot Physics: no gyroscopic torque.

#include <timestep/gyroscopic/no_gyroscopic.hpp>

#include "new_spin.hpp"

namespace timestep {

/// ω₂ = ω₁. The energy stays; L, which should, does not, and nothing tumbles.
struct GodotSpin : NewSpin<NoGyroscopic> {
    static constexpr const char* name = "Godot";  ///< for tables and keys
};

inline constexpr GodotSpin godot_spin;  ///< the method as a value

}  // namespace timestep
