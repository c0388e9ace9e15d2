#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> best = rounds[0];
    for (const auto& round : rounds)
        if (round[0] < best[0]) best = round;
    return (best[0] - best[2]) / (best[1] - best[2]);
}
