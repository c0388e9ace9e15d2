#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double weight = mass * g;
    const double k = 0.25 * weight / sag;
    return {k, zeta * std::sqrt(k * mass)};
}
