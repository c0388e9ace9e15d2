#include "exercise.hpp"

static double fastest(const std::vector<std::array<double, 3>>& rounds, std::size_t column) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& round : rounds)
        if (round[column] < least) least = round[column];
    return least;
}
double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    const double empty = fastest(rounds, 2);
    return (fastest(rounds, 0) - empty) / (fastest(rounds, 1) - empty);
}
