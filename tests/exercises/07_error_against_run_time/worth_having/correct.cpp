#include "exercise.hpp"

namespace everybody_with_everybody {

using Point = std::array<double, 2>;

static bool usable(const Point& point) { return std::isfinite(point[0]) && std::isfinite(point[1]); }

static bool beats(const Point& a, const Point& b) {
    return a[0] <= b[0] && a[1] <= b[1] && (a[0] < b[0] || a[1] < b[1]);
}
std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> worth;
    for (int i = 0; i < int(points.size()); ++i) {
        bool beaten = !usable(points[i]);
        for (const Point& other : points)
            if (usable(other) && beats(other, points[i])) beaten = true;
        if (!beaten) worth.push_back(i);
    }
    std::stable_sort(worth.begin(), worth.end(), [&](int i, int j) { return points[i] < points[j]; });
    return worth;
}

}  // namespace everybody_with_everybody

namespace fastest_again_and_again {

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    // The most accurate of the fastest, then the fastest of those more accurate than that.
    std::vector<int> worth;
    double error = std::numeric_limits<double>::infinity();
    for (;;) {
        int best = -1;
        for (int i = 0; i < static_cast<int>(points.size()); ++i) {
            if (!std::isfinite(points[i][0]) || !(points[i][1] < error)) continue;
            if (best < 0 || points[i] < points[best]) best = i;
        }
        if (best < 0) return worth;
        for (int i = 0; i < static_cast<int>(points.size()); ++i)
            if (points[i] == points[best]) worth.push_back(i);
        error = points[best][1];
    }
}

}  // namespace fastest_again_and_again

namespace one_after_another {

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    // Who comes in throws out those whom it beats.
    using Point = std::array<double, 2>;
    const auto beats = [](const Point& a, const Point& b) { return a[0] <= b[0] && a[1] <= b[1] && a != b; };
    std::vector<int> worth;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        const Point& point = points[i];
        if (!std::isfinite(point[0] + point[1])) continue;
        if (std::any_of(worth.begin(), worth.end(), [&](int k) { return beats(points[k], point); })) continue;
        worth.erase(std::remove_if(worth.begin(), worth.end(), [&](int k) { return beats(point, points[k]); }),
                    worth.end());
        const auto slower = std::find_if(worth.begin(), worth.end(), [&](int k) { return points[k][0] > point[0]; });
        worth.insert(slower, i);
    }
    return worth;
}

}  // namespace one_after_another
