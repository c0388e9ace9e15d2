#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> sum{};
    for (const auto& round : rounds)
        for (std::size_t i = 0; i < 3; ++i) sum[i] += round[i];
    return (sum[0] - sum[2]) / (sum[1] - sum[2]);
}
