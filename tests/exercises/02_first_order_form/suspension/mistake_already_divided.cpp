#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / (4 * sag), 2 * zeta * std::sqrt(g / sag)};
}
