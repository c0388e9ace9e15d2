#include "exercise.hpp"

double velocity_under_drag(double v, double gravity, double k, double h) {
    const float w = static_cast<float>(v - h * gravity), q = static_cast<float>(h * k);
    return 2 * w / (1 + std::sqrt(1 + 4 * q * std::fabs(w)));
}
