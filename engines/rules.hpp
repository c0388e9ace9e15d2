#pragma once
/// \file
/// Every method of the appendix, for programs and tests that go through all of them.

#include <tuple>

#include "adams_bashforth.hpp"
#include "box3d.hpp"
#include "bullet.hpp"
#include "buss.hpp"
#include "explicit_euler.hpp"
#include "godot.hpp"
#include "jolt.hpp"
#include "magnus.hpp"
#include "midpoint.hpp"
#include "moser_veselov.hpp"
#include "mujoco.hpp"
#include "ode.hpp"
#include "spiers.hpp"

namespace timestep {

/// Calls `visit(method)` for each rule of an engine.
template <class Visit>
void for_each_engine(const Visit& visit) {
    std::apply([&](const auto&... method) { (visit(method), ...); },
               std::tuple{box3d_spin, bullet_spin, mujoco_spin, jolt_spin, ode_spin, godot_spin, explicit_spin});
}

/// Calls `visit(method)` for each method from a book.
template <class Visit>
void for_each_book(const Visit& visit) {
    std::apply([&](const auto&... method) { (visit(method), ...); },
               std::tuple{midpoint_spin, moser_veselov_2, moser_veselov_4, magnus_taylor, buss_2, buss_augmented,
                          AdamsBashforthSpin<double>{}, spiers_spin, avian_spin});
}

}  // namespace timestep
