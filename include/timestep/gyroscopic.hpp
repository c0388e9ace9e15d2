#pragma once
/// \file
/// Every way to treat the gyroscopic torque, for programs and tests that go through all of them.

#include <tuple>

#include <timestep/gyroscopic/converged_gyroscopic.hpp>
#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/no_gyroscopic.hpp>
#include <timestep/gyroscopic/lagged_inertia.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>

namespace timestep {

/// Calls `visit(solver)` for each, in the order in which the course meets them.
template <class Visit>
void for_each_gyroscopic(const Visit& visit) {
    std::apply([&](const auto&... solver) { (visit(solver), ...); },
               std::tuple{explicit_gyroscopic, no_gyroscopic, lagged_inertia, implicit_gyroscopic,
                          converged_gyroscopic, passive_gyroscopic});
}

}  // namespace timestep
