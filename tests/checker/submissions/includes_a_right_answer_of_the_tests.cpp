// velocity_now does_not_compile: includes tests/exercises/01_derivatives/velocity_now/correct.cpp
#include "exercise.hpp"

#include "../../exercises/01_derivatives/velocity_now/correct.cpp"
