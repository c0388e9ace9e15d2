#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 2> least{};
    for (std::size_t i = 0; i < 2; ++i) {
        least[i] = std::numeric_limits<double>::infinity();
        for (const auto& round : rounds) least[i] = std::min(least[i], round[i] - round[2]);
    }
    return least[0] / least[1];
}
