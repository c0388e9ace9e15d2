#include "exercise.hpp"

namespace columns {

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

}  // namespace columns

namespace differences {

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    // Without the loop, which is what the fastest of its rounds says.
    const auto by = [&](std::size_t i) {
        return (*std::min_element(rounds.begin(), rounds.end(),
                                  [&](const auto& p, const auto& q) { return p[i] < q[i]; }))[i];
    };
    const double b = by(1) - by(2);
    return 1 + (by(0) - by(1)) / b;
}

}  // namespace differences

namespace sorted {

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

}  // namespace sorted
