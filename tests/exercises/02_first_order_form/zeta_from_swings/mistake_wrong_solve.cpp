#include "exercise.hpp"

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / swings, turn = 2 * std::numbers::pi;
    return d / std::sqrt(turn * turn - d * d);
}
