#include "exercise.hpp"

double zeta_from_swings(double first, double later, int swings) {
    // Set ω√(1 − ζ²) = 1: a swing takes 2π, the decay rate is ζ/√(1 − ζ²), the tangent of an angle.
    const double time = 2 * std::numbers::pi * swings;
    const double rate = -std::log(later / first) / time;
    return std::sin(std::atan(rate));
}
