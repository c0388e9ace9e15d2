#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double seconds = (b[1] - a[1] + q * b[0] - p * a[0]) / (q - p);
    return {seconds, a[1] - p * (seconds - a[0])};
}
