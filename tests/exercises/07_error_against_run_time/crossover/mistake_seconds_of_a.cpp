#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_of_1 = a[0] * std::pow(a[1], 1.0 / p), b_of_1 = b[0] * std::pow(b[1], 1.0 / q);
    return {a[0], std::pow(a_of_1 / b_of_1, 1 / (1.0 / p - 1.0 / q))};
}
