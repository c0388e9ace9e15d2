#pragma once
/// \file
/// The Open Dynamics Engine: the angular momentum of the old state, the spin of the new one.

#include <timestep/gyroscopic/passive_gyroscopic.hpp>

#include "new_spin.hpp"

namespace timestep {

/// I(ω₂ − ω₁) = h L₁ × ω₂, or (I − h skew(L₁)) ω₂ = L₁ (Lacoursière 2006). PassiveGyroscopic is its
/// solution in closed form; ODE inverts the matrix. The energy never grows, and decays.
struct OdeSpin : NewSpin<PassiveGyroscopic> {
    static constexpr const char* name = "ODE";  ///< for tables and keys
};

inline constexpr OdeSpin ode_spin;  ///< the method as a value

}  // namespace timestep
