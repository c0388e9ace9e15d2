#pragma once
// The functions of gyroscopic.h by number type, and the rule of the library that each is compared with.

#include <type_traits>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>

#include "calls.h"

template <class Real>
using Body = std::conditional_t<std::is_same_v<Real, float>, gyroscopic_bodyf, gyroscopic_body>;

template <class Real>
const auto& functions() {
    if constexpr (std::is_same_v<Real, float>)
        return callsf;
    else
        return calls;
}

// Calls `visit(i, rule)` with the library's rule for functions<Real>().rule[i].
template <class Visit>
void for_each_rule(const Visit& visit) {
    visit(0, timestep::passive_gyroscopic);
    visit(1, timestep::half_step_jacobian);
    visit(2, timestep::calm_half_step);
}
