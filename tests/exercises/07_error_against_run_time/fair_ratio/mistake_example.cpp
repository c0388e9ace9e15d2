#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    return 2;
}
