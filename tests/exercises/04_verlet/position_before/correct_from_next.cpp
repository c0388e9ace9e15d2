#include "exercise.hpp"

// Verlet's step must lead to the position after this one: solved for what stands before.
double position_before(double x, double v, double a, double h) {
    const double next = x + h * v + h * h / 2 * a;
    return 2 * x - next + h * h * a;
}
