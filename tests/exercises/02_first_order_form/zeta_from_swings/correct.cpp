#include "exercise.hpp"

namespace period {

double zeta_from_swings(double first, double later, int swings) {
    // Set ω√(1 − ζ²) = 1: an oscillation takes 2π, the decay rate is ζ/√(1 − ζ²), the tangent of an angle.
    const double time = 2 * std::numbers::pi * swings;
    const double rate = -std::log(later / first) / time;
    return std::sin(std::atan(rate));
}

}  // namespace period

namespace squares {

double zeta_from_swings(double first, double later, int swings) {
    // δ² (1 − ζ²) = 4π² ζ², with δ the logarithm of all swings.
    const double delta = std::log(std::abs(first)) - std::log(std::abs(later));
    const double turn = 2 * std::numbers::pi * swings;
    const double squared = delta * delta / (turn * turn + delta * delta);
    return std::sqrt(squared);
}

}  // namespace squares

namespace root_first {

double zeta_from_swings(double first, double later, int swings) {
    // What one period leaves, and its logarithm; with as many digits of π as one knows.
    const double left = std::pow(later / first, 1.0 / swings);
    const double decrement = -std::log(left), turn = 2 * 3.141592654;
    return decrement / std::sqrt(turn * turn + decrement * decrement);
}

}  // namespace root_first
