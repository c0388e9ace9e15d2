#include "exercise.hpp"

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega;
    return {1 / (h * (c + h * k)), k / (c + h * k)};
}
