#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double carried = mass / 4, k = carried * g / sag;
    return {k, 2 * zeta * std::sqrt(k * carried) / 4};
}
