#include "exercise.hpp"

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> worth;
    for (int i = 0; i < int(points.size()); ++i) {
        bool beaten = !std::isfinite(points[i][0]) || !std::isfinite(points[i][1]);
        for (int k = 0; k < int(points.size()); ++k)
            if (k != i && points[k][0] <= points[i][0] && points[k][1] <= points[i][1])
                beaten = true;
        if (!beaten) worth.push_back(i);
    }
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    return worth;
}
