// Every solver with every inertia, in `float`.

#include "extreme_bodies.hpp"

template std::vector<extremes::Cell> extremes::of_bodies_in<float>();
