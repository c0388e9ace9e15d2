#include "exercise.hpp"

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double slowed = 2 * v / (1 + std::sqrt(1 + 4 * h * k * std::fabs(v)));
    return slowed - h * gravity;
}
