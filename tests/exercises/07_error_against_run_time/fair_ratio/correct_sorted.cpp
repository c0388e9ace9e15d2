#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    std::vector<double> a, b, empty;
    for (const auto& round : rounds) {
        a.push_back(round[0]);
        b.push_back(round[1]);
        empty.push_back(round[2]);
    }
    for (auto* times : {&a, &b, &empty}) std::sort(times->begin(), times->end());
    return (a.front() - empty.front()) / (b.front() - empty.front());
}
