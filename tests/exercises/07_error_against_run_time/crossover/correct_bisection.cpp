#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const auto log_seconds = [](const std::array<double, 2>& run, int order, double log_error) {
        return std::log(run[0]) + (std::log(run[1]) - log_error) / order;
    };
    double low = -600, high = 600;  // logarithms of the error
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (log_seconds(a, p, middle) < log_seconds(b, q, middle) ? high : low) = middle;
    }
    return {std::exp(log_seconds(a, p, low)), std::exp(low)};
}
