#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double x = (std::log(b[1]) - std::log(a[1])) / (q - p);
    return {std::exp(x), std::exp(std::log(a[1]) - p * x)};
}
