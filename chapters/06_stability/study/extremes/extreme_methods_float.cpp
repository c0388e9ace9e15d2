// Every method in every scene, in `float`.

#include "extreme_methods.hpp"

template std::vector<extremes::Cell> extremes::of_methods_in<float>();
