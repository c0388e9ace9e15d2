#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    return {std::sqrt(a[0] * b[0]), std::sqrt(a[1] * b[1])};
}
