#include "exercise.hpp"

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> order;
    for (int i = 0; i < int(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    std::vector<int> worth;
    for (const int i : order) {
        const auto& point = points[i];
        if (worth.empty() || point[1] <= points[worth.back()][1]) worth.push_back(i);
    }
    return worth;
}
