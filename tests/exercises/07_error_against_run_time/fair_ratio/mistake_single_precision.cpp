#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<float, 3> fastest{1e6f, 1e6f, 1e6f};
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], float(round[i]));
    return (fastest[0] - fastest[2]) / (fastest[1] - fastest[2]);
}
