// velocity_now does_not_compile: forgets_to_return.cpp:6:1: error:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    const double velocity = (3 * x2 - 4 * x1 + x0) / (2 * h);
}
