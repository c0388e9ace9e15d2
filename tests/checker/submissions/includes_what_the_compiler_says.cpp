// velocity_now does_not_compile: The compiler had not come to an end
#include "exercise.hpp"

#include "/proc/self/fd/1"
