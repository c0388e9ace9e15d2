#include "exercise.hpp"

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity, q = h * k;
    if (q == 0) return w;
    const double size = (std::sqrt(1 + 4 * q * std::fabs(w)) - 1) / (2 * q);
    return w < 0 ? -size : size;
}
