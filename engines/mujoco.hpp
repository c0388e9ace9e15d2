#pragma once
/// \file
/// MuJoCo's integrator "implicitfast" on a free body.

#include <timestep/gyroscopic/implicit_gyroscopic.hpp>

#include "new_spin.hpp"

namespace timestep {

/// (I + h G)(ω₂ − ω₁) = −h ω₁ × Iω₁, where G is the derivative of ω × Iω by ω: one Newton step on
/// implicit Euler's equation, from ω₁. That is the talk's solver. MuJoCo solves it by elimination
/// with pivots, in double, so that no unit of length is too small for it.
struct MujocoSpin : NewSpin<ImplicitGyroscopic> {
    static constexpr const char* name = "MuJoCo";  ///< for tables and keys
};

inline constexpr MujocoSpin mujoco_spin;  ///< the method as a value

}  // namespace timestep
