// velocity_now does_not_compile
#include "exercise.hpp"

#include "/proc/self/mem"
