#include "exercise.hpp"

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]);
}

static bool beats(const Point& a, const Point& b) {
    return a[0] < b[0] && a[1] < b[1];
}
std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> worth;
    for (int i = 0; i < int(points.size()); ++i) {
        bool beaten = !usable(points[i]);
        for (const Point& other : points)
            if (usable(other) && beats(other, points[i])) beaten = true;
        if (!beaten) worth.push_back(i);
    }
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    return worth;
}
