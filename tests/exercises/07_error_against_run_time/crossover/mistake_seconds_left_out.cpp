#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double root_a = std::pow(a[1], 1.0 / p), root_b = std::pow(b[1], 1.0 / q);
    const double error = std::pow(root_a / root_b, 1 / (1.0 / p - 1.0 / q));
    return {a[0] * root_a / std::pow(error, 1.0 / p), error};
}
