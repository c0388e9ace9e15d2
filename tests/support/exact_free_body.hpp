#pragma once
// The exact motion of a free body, compiled once for all tests: in library/rigid_exact.cpp.

#include <timestep/rigid/exact_free_body.hpp>

extern template class timestep::ExactFreeBody<float>;
extern template class timestep::ExactFreeBody<double>;
