#include "exercise.hpp"

namespace bisection {

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

}  // namespace bisection

namespace from_a_on {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    // B's run, made as accurate as A's. Then both are `longer` times as long.
    const double seconds_b = b[0] * std::pow(b[1] / a[1], 1.0 / q);
    const double longer = std::pow(seconds_b / a[0], double(q) / (q - p));
    return {a[0] * longer, a[1] * std::pow(longer, -p)};
}

}  // namespace from_a_on

namespace two_lines {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    // y = log of the error, over x = log of the seconds: two straight lines, -p and -q steep.
    const double x_a = std::log(a[0]), y_a = std::log(a[1]);
    const double x_b = std::log(b[0]), y_b = std::log(b[1]);
    const double x = (y_b - y_a + q * x_b - p * x_a) / (q - p);
    return {std::exp(x), std::exp(y_a - p * (x - x_a))};
}

}  // namespace two_lines
