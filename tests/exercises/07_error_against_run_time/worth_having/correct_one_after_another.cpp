#include "exercise.hpp"

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    // Who comes in throws out those whom it beats.
    using Point = std::array<double, 2>;
    const auto beats = [](const Point& a, const Point& b) {
        return a[0] <= b[0] && a[1] <= b[1] && a != b;
    };
    std::vector<int> worth;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        const Point& point = points[i];
        if (!std::isfinite(point[0] + point[1])) continue;
        if (std::any_of(worth.begin(), worth.end(), [&](int k) { return beats(points[k], point); }))
            continue;
        worth.erase(std::remove_if(worth.begin(), worth.end(),
                                   [&](int k) { return beats(point, points[k]); }),
                    worth.end());
        const auto slower = std::find_if(worth.begin(), worth.end(),
                                         [&](int k) { return points[k][0] > point[0]; });
        worth.insert(slower, i);
    }
    return worth;
}
