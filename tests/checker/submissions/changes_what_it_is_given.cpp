// fair_ratio wrong: the arguments are only read
#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    auto& mine = const_cast<std::vector<std::array<double, 3>>&>(rounds);
    std::sort(mine.begin(), mine.end(), std::greater<>());
    mine.push_back({1, 2, 3});
    return 1;
}
