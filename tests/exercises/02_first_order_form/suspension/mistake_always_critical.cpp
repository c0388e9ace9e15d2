#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / (4 * sag), mass / 2 * std::sqrt(g / sag)};
}
