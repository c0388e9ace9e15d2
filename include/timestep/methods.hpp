#pragma once
/// \file
/// Every method of the course, for programs and tests that go through all of them.

#include <tuple>

#include <timestep/methods/bdf2.hpp>
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/heun.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/implicit_midpoint.hpp>
#include <timestep/methods/leapfrog.hpp>
#include <timestep/methods/midpoint.hpp>
#include <timestep/methods/constant_acceleration.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/velocity_verlet.hpp>
#include <timestep/methods/verlet.hpp>

namespace timestep {

/// The methods that step any smooth force, in the order in which the course meets them.
inline constexpr std::tuple all_methods{explicit_euler, implicit_euler, semi_implicit_euler,
                                        midpoint,       heun,           implicit_midpoint,
                                        bdf2,           runge_kutta_4};

/// Calls `visit(method)` for each of them.
template <class Visit>
void for_each_method(const Visit& visit) {
    std::apply([&](const auto&... method) { (visit(method), ...); }, all_methods);
}

/// The methods of chapter 4. All but `constant_acceleration` step a PositionForce only.
inline constexpr std::tuple verlet_methods{verlet, velocity_verlet, leapfrog,
                                           constant_acceleration};

/// Calls `visit(method)` for each of those.
template <class Visit>
void for_each_verlet_method(const Visit& visit) {
    std::apply([&](const auto&... method) { (visit(method), ...); }, verlet_methods);
}

}  // namespace timestep
