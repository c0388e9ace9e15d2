#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::array<double, 3> middle{};
    for (std::size_t i = 0; i < 3; ++i) {
        std::vector<double> times;
        for (const auto& round : rounds) times.push_back(round[i]);
        std::sort(times.begin(), times.end());
        middle[i] = times[times.size() / 2];
    }
    return (middle[0] - middle[2]) / (middle[1] - middle[2]);
}
