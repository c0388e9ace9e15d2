#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double x_a = std::log(a[0]), y_a = std::log(a[1]);
    const double x_b = std::log(b[0]), y_b = std::log(b[1]);
    const double x = (y_b - y_a + q * x_b - p * x_a) / (q - p);
    return {std::exp(x), std::exp(y_a + p * (x - x_a))};
}
