#include "exercise.hpp"

namespace back_step {

// The Taylor series of the first step, run with the step −h.
static double taylor(double x, double v, double a, double h) { return x + h * (v + h * a / 2); }

double position_before(double x, double v, double a, double h) { return taylor(x, v, a, -h); }

}  // namespace back_step

namespace from_next {

// Verlet's step must lead to the position after this one: solved for what stands before.
double position_before(double x, double v, double a, double h) {
    const double next = x + h * v + h * h / 2 * a;
    return 2 * x - next + h * h * a;
}

}  // namespace from_next

namespace middle {

// The velocity in the middle of the step before took it from there to here.
double position_before(double x, double v, double a, double h) {
    const double v_middle = v - h / 2 * a;
    return x - h * v_middle;
}

}  // namespace middle
