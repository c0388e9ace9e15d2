#include "exercise.hpp"

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    // B's run, made as accurate as A's. Then both are `longer` times as long.
    const double seconds_b = b[0] * std::pow(b[1] / a[1], 1.0 / q);
    const double longer = std::pow(seconds_b / a[0], double(q) / (q - p));
    return {a[0] * longer, a[1] * std::pow(longer, -p)};
}
