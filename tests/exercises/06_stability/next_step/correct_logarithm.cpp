#include "exercise.hpp"

// The factor's logarithm is the mean of what has to be made up for, over order + 1 powers.
double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double difference = std::abs(halves - whole);
    if (!(difference < std::numeric_limits<double>::infinity())) return 0.2 * h;
    const double allowed = tolerance * (std::pow(2, order) - 1);
    const double log_factor = (std::log(allowed) - std::log(difference)) / (order + 1);
    return std::min(5 * h, std::max(0.2 * h, 0.9 * h * std::exp(log_factor)));
}
