#include "exercise.hpp"

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> order, worth;
    for (int i = 0; i < int(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    for (std::size_t k = 0; k < order.size(); ++k)
        if (k == 0 || points[order[k]][1] < points[order[k - 1]][1] ||
            points[order[k]] == points[order[k - 1]])
            worth.push_back(order[k]);
    return worth;
}
