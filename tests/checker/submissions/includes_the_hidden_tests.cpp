// velocity_now does_not_compile: properties.cpp
#include "exercise.hpp"

#include "../../exercises/01_derivatives/velocity_now/properties.cpp"
