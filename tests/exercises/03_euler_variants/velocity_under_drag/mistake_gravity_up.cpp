#include "exercise.hpp"

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v + h * gravity;
    return 2 * w / (1 + std::sqrt(1 + 4 * h * k * std::fabs(w)));
}
