#include "exercise.hpp"

// The Taylor series of the first step, run with the step −h.
static double taylor(double x, double v, double a, double h) {
    return x + h * (v + h * a / 2);
}

double position_before(double x, double v, double a, double h) {
    return taylor(x, v, a, -h);
}
