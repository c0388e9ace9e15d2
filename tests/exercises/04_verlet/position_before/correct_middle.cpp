#include "exercise.hpp"

// The velocity in the middle of the step before took it from there to here.
double position_before(double x, double v, double a, double h) {
    const double v_middle = v - h / 2 * a;
    return x - h * v_middle;
}
