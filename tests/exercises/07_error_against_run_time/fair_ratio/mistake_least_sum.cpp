#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    const auto sum = [](const std::array<double, 3>& round) {
        return round[0] + round[1] + round[2];
    };
    std::array<double, 3> best = rounds[0];
    for (const auto& round : rounds)
        if (sum(round) < sum(best)) best = round;
    return (best[0] - best[2]) / (best[1] - best[2]);
}
