#pragma once
// The advice on one method, for tests.

#include <catch2/catch_test_macros.hpp>

#include <string>
#include <vector>

#include "advise.hpp"

namespace timestep {

inline const Advice& of(const std::vector<Advice>& all, const std::string& method) {
    for (const Advice& advice : all)
        if (advice.method == method) return advice;
    FAIL("no advice on " << method);
    return all.front();
}

// Every method that steps a damper.
template <class Visit>
void for_each_damped(const Visit& visit) {
    for_each_method(visit);
    visit(semi_implicit_euler_new_damping);
    visit(constant_acceleration);
}

}  // namespace timestep
