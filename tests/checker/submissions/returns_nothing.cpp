// velocity_now does_not_compile: The type it returns, name and arguments must stay as they were.
#include "exercise.hpp"

void velocity_now(double, double, double, double) {}
