#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double carried = mass / 4, omega = std::sqrt(g / sag);
    return {carried * omega * omega / 4, 2 * zeta * carried * omega / 4};
}
