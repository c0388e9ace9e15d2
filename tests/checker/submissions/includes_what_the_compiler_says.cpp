// velocity_now does_not_compile: No such device or address
#include "exercise.hpp"

#include "/proc/self/fd/1"
