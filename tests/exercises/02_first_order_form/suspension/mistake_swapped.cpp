#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {2 * zeta * mass / 4 * std::sqrt(g / sag), mass * g / (4 * sag)};
}
