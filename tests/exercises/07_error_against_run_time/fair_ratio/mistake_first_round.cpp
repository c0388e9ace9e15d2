#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    const auto [a, b, empty] = rounds[0];
    return (a - empty) / (b - empty);
}
