#include "exercise.hpp"

// Newton-Raphson from the velocity without drag: the equation is convex on the way, so the iterates
// fall towards the root from one side and do not miss it.
double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity, size = std::fabs(w), q = h * k;
    double s = size;
    for (int i = 0; i < 60; ++i) s -= (s + q * s * s - size) / (1 + 2 * q * s);
    return std::copysign(s, w);
}
