#pragma once
/// \file
/// Every method of the course so far, for programs and tests that go through all of them.

#include <tuple>

#include <timestep/methods/bdf2.hpp>
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/heun.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/implicit_midpoint.hpp>
#include <timestep/methods/midpoint.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>

namespace timestep {

/// The methods that step any smooth force, in the order in which the course meets them.
inline constexpr std::tuple all_methods{explicit_euler, implicit_euler,    semi_implicit_euler, midpoint,
                                        heun,           implicit_midpoint, bdf2,                runge_kutta_4};

/// Calls `visit(method)` for each of them.
template <class Visit>
void for_each_method(const Visit& visit) {
    std::apply([&](const auto&... method) { (visit(method), ...); }, all_methods);
}

}  // namespace timestep
