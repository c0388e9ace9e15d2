#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> most = rounds[0];
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) most[i] = std::max(most[i], round[i]);
    return (most[0] - most[2]) / (most[1] - most[2]);
}
