#include "exercise.hpp"

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = omega * omega, c = 2 * zeta * omega;
    return {1 / (h * (c + h * k)), h * k / (c + h * k)};
}
