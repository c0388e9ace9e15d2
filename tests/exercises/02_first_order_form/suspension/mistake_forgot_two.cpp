#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / (4 * sag), zeta * mass / 4 * std::sqrt(g / sag)};
}
