#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> fastest = rounds[0];
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], round[i]);
    return (fastest[0] - fastest[2]) / fastest[1];
}
