#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> fastest = rounds[0];
    double sum = 0;
    for (const auto& round : rounds) {
        for (std::size_t i = 0; i < 3; ++i) fastest[i] = std::min(fastest[i], round[i]);
        sum += round[2];
    }
    const double empty = sum / double(rounds.size());
    return (fastest[0] - empty) / (fastest[1] - empty);
}
