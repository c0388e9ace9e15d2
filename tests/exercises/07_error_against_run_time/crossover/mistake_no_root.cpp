#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    // After S seconds the error is a_at_1 / S^p, and b_at_1 / S^q.
    const double a_at_1 = a[1] * std::pow(a[0], p), b_at_1 = b[1] * std::pow(b[0], q);
    const double seconds = b_at_1 / a_at_1;
    return {seconds, a_at_1 / std::pow(seconds, p)};
}
