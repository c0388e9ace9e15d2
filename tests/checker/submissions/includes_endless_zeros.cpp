// velocity_now does_not_compile
#include "exercise.hpp"

#include "/dev/zero"
