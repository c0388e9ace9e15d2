#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / sag, 2 * zeta * mass * std::sqrt(g / sag)};
}
