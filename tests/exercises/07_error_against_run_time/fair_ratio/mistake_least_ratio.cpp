#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, empty] : rounds) least = std::min(least, (a - empty) / (b - empty));
    return least;
}
