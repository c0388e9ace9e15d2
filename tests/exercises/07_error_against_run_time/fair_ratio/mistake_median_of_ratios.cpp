#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::vector<double> ratios;
    for (const auto& [a, b, empty] : rounds) ratios.push_back((a - empty) / (b - empty));
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() / 2];
}
