#include "exercise.hpp"

double zeta_from_swings(double first, double later, int swings) {
    // δ² (1 − ζ²) = 4π² ζ², with δ the logarithm of all swings.
    const double delta = std::log(std::abs(first)) - std::log(std::abs(later));
    const double turn = 2 * std::numbers::pi * swings;
    const double squared = delta * delta / (turn * turn + delta * delta);
    return std::sqrt(squared);
}
