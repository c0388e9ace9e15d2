#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double k = mass * g / (4 * sag);
    return {k, 2 * zeta * std::sqrt(k * mass)};
}
