#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double omega = std::sqrt(9.81 / sag);
    return {mass / 4 * omega * omega, 2 * zeta * mass / 4 * omega};
}
