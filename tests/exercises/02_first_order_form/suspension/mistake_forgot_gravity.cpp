#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass / (4 * sag), 2 * zeta * mass / 4 * std::sqrt(1 / sag)};
}
