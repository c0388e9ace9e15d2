#include "exercise.hpp"

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double w = 2 * std::numbers::pi * omega;
    const double k = mass * w * w, c = 2 * mass * zeta * w;
    return {1 / (h * (c + h * k)), h * k / (c + h * k)};
}
