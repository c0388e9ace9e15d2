#pragma once
// What the two files of the appendix's program share.

#include <timestep/rigid/spin_state.hpp>

#include "appendix/others.hpp"
#include "lab.hpp"

void engines(lab::Findings& out);       // engines.cpp
void engines_fail(lab::Findings& out);  // engines_fail.cpp

namespace appendix {

using Spin = timestep::SpinState<double>;

// A body at rest in its own axes, turning with that ω, rad/s.
inline Spin spin_of(double x, double y, double z) {
    return {0, timestep::Quaternion<double>::Identity(), {x, y, z}};
}

// The state after so many steps.
template <class Method, class Inertia, class State, class Real>
State spun(const Method& method, const Inertia& inertia, State s, Real h, long steps) {
    for (long n = 0; n < steps; ++n) s = method.step(inertia, s, h);
    return s;
}

}  // namespace appendix
