// velocity_now does_not_compile: includes solutions/01_derivatives/velocity_now.cpp
#include "exercise.hpp"

#include "../../../solutions/01_derivatives/velocity_now.cpp"
