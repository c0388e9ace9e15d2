#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    // Without the loop, which is what the fastest of its rounds says.
    const auto by = [&](std::size_t i) {
        return (*std::min_element(rounds.begin(), rounds.end(),
                                  [&](const auto& p, const auto& q) { return p[i] < q[i]; }))[i];
    };
    const double b = by(1) - by(2);
    return 1 + (by(0) - by(1)) / b;
}
