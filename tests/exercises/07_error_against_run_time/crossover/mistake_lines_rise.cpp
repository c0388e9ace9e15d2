#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double x = (std::log(b[1] / a[1]) + p * std::log(a[0]) - q * std::log(b[0])) / (p - q);
    return {std::exp(x), a[1] * std::pow(std::exp(x) / a[0], p)};
}
