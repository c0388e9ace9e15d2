#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    double sum = 0;
    for (const auto& [a, b, empty] : rounds) sum += (a - empty) / (b - empty);
    return sum / double(rounds.size());
}
