#pragma once
// What the two files of the appendix's program share.

#include "lab.hpp"
#include "methods.hpp"

void engines(lab::Findings& out);       // engines.cpp
void engines_fail(lab::Findings& out);  // engines_fail.cpp

namespace appendix {

// A body at rest in its own axes, turning with that ω, rad/s.
inline Spin spin_of(double x, double y, double z) { return spinning({x, y, z}); }

}  // namespace appendix
