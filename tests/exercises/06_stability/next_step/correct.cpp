#include "exercise.hpp"

namespace constant_of_error {

// By the constant C itself: the halves of a step are off by C h^(order + 1) / 2^order.
double next_step(double whole, double halves, double h, double tolerance, int order) {
    if (!std::isfinite(whole) || !std::isfinite(halves)) return h / 5;
    const double part = 1 - 1 / std::pow(2.0, order);   // of the error of the whole step
    const double e = std::fabs(whole - halves) / part;  // C h^(order + 1)
    const double wanted = tolerance * std::pow(2.0, order);
    double next = 5 * h;
    if (e > 0) next = 0.9 * h / std::pow(e / wanted, 1.0 / (1 + order));
    if (next > 5 * h) next = 5 * h;
    if (next < h / 5) next = h / 5;
    return next;
}

}  // namespace constant_of_error

namespace logarithm {

// The factor's logarithm is the mean of what has to be made up for, over order + 1 powers.
double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double difference = std::abs(halves - whole);
    if (!(difference < std::numeric_limits<double>::infinity())) return 0.2 * h;
    const double allowed = tolerance * (std::pow(2, order) - 1);
    const double log_factor = (std::log(allowed) - std::log(difference)) / (order + 1);
    return std::min(5 * h, std::max(0.2 * h, 0.9 * h * std::exp(log_factor)));
}

}  // namespace logarithm
