#pragma once
// gyroscopic.h for templates, and a rule of the library beside each function.

#include <type_traits>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>

#include "calls.h"

template <class Real>
using Body = std::conditional_t<std::is_same_v<Real, float>, gyroscopic_bodyf, gyroscopic_body>;

template <class Real>
const auto& of() {
    if constexpr (std::is_same_v<Real, float>)
        return callsf;
    else
        return calls;
}

// Calls `look(i, rule)` with the library's rule beside of<Real>().rule[i].
template <class Look>
void for_each_rule(const Look& look) {
    look(0, timestep::passive_gyroscopic);
    look(1, timestep::half_step_jacobian);
    look(2, timestep::calm_half_step);
}
