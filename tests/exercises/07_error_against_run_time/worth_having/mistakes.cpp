#include "exercise.hpp"

// Says: A setting is thrown out only if another is truly better in both respects. One that is as fast and
//       more accurate beats it as well.
// Hint: Of two settings that take the same time, who would want the less accurate?
namespace worse_in_both {

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
                     [&](int i, int j) { return points[i][0] < points[j][0]; });
    return worth;
}

}  // namespace worse_in_both

// Says: A setting is thrown out as soon as another is better in one respect. Then only one that is the best
//       in both is left, and mostly there is none.
// Hint: Somebody wants speed, and somebody accuracy. Who beats another must not be worse in anything.
namespace worse_in_one {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]);
}

static bool beats(const Point& a, const Point& b) {
    return a[0] < b[0] || a[1] < b[1];
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

}  // namespace worse_in_one

// Says: Nobody is worth having: each setting is compared with itself too, and takes no more time than
//       itself.
// Hint: To beat somebody one must be truly better in something.
namespace beaten_by_itself {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]);
}

static bool beats(const Point& a, const Point& b) {
    return a[0] <= b[0] && a[1] <= b[1];
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

}  // namespace beaten_by_itself

// Says: Twins throw each other out: each takes no more time than the other and has no larger error.
// Hint: No more in both is not enough. One of the two must be truly less.
namespace twins_beat_each_other {

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

}  // namespace twins_beat_each_other

// Says: Of twins you return only the first. They do not beat each other.
// Hint: What do you ask of a setting that has the same error as the best so far, and the same time?
namespace one_of_twins {

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> order;
    for (int i = 0; i < int(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    std::vector<int> worth;
    for (const int i : order) {
        const auto& point = points[i];
        if (worth.empty() || point[1] < points[worth.back()][1]) worth.push_back(i);
    }
    return worth;
}

}  // namespace one_of_twins

// Says: You have sorted by the seconds alone. Of settings with the same time the less accurate may come
//       first, and stays.
// Hint: Where the seconds are equal, who must come first so that it can throw out the other?
namespace same_time_kept {

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> order;
    for (int i = 0; i < int(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return points[i][0] < points[j][0]; });
    std::vector<int> worth;
    for (const int i : order) {
        const auto& point = points[i];
        if (worth.empty() || point[1] < points[worth.back()][1] || point == points[worth.back()])
            worth.push_back(i);
    }
    return worth;
}

}  // namespace same_time_kept

// Says: A setting that takes longer for the same error stays in: you throw out only those with a larger one.
// Hint: No more accurate than a faster one is not worth the time.
namespace same_error_kept {

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

}  // namespace same_error_kept

// Says: Each setting is compared with the next faster one only. That one may itself be bad, and a third beat
//       both.
// Hint: Keep in mind the least error of all that are faster.
namespace neighbours_only {

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

}  // namespace neighbours_only

// Says: The right settings, but as they stand in the list: the fastest does not come first.
// Hint: Sort the places at the end, by the seconds of their points.
namespace list_order {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]);
}

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
    return worth;
}

}  // namespace list_order

// Says: The right settings, but the slowest first.
// Hint: Sort the other way round; twins stay as they stand in the list.
namespace slowest_first {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]);
}

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
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[j] < points[i]; });
    return worth;
}

}  // namespace slowest_first

// Says: You return the fastest setting only, and its twins.
// Hint: Somebody else wants to be accurate, and is ready to wait.
namespace fastest_only {

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> order;
    for (int i = 0; i < int(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    std::vector<int> worth;
    for (const int i : order) {
        const auto& point = points[i];
        if (worth.empty() || point == points[worth.back()]) worth.push_back(i);
    }
    return worth;
}

}  // namespace fastest_only

// Says: You return the fastest setting and the most accurate one. What lies between may be worth having,
//       too.
// Hint: A setting need not be the best in anything. It is enough that nobody is at least as good in both.
namespace ends_only {

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> order;
    for (int i = 0; i < int(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    std::vector<int> worth;
    for (const int i : order) {
        const auto& point = points[i];
        if (worth.empty() || point[1] < points[worth.back()][1] || point == points[worth.back()])
            worth.push_back(i);
    }
    std::vector<int> ends;
    for (const int i : worth)
        if (points[i] == points[worth.front()] || points[i] == points[worth.back()])
            ends.push_back(i);
    return ends;
}

}  // namespace ends_only

// Says: The larger error wins in your comparison.
// Hint: An error is better if it is smaller.
namespace error_upside_down {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]);
}

static bool beats(const Point& a, const Point& b) {
    return a[0] <= b[0] && a[1] >= b[1] && (a[0] < b[0] || a[1] > b[1]);
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

}  // namespace error_upside_down

// Says: You return those that are beaten.
// Hint: Turn the decision round. What blew up stays out in any case.
namespace the_others {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]);
}

static bool beats(const Point& a, const Point& b) {
    return a[0] <= b[0] && a[1] <= b[1] && (a[0] < b[0] || a[1] < b[1]);
}
std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> worth;
    for (int i = 0; i < int(points.size()); ++i) {
        bool beaten = !usable(points[i]);
        for (const Point& other : points)
            if (usable(other) && beats(other, points[i])) beaten = true;
        if (beaten && usable(points[i])) worth.push_back(i);
    }
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[i][0] < points[j][0]; });
    return worth;
}

}  // namespace the_others

// Says: Settings that blew up are worth having to you: no comparison with NaN is true, so nobody beats it;
//       and an infinite error that came fast is not beaten either.
// Hint: Sort out what is not finite before you compare: std::isfinite of both numbers.
namespace blown_up_kept {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return point.size() == 2;
}

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
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    return worth;
}

}  // namespace blown_up_kept

// Says: NaN is sorted out, but not infinity: a setting that was fast and is infinitely far off is offered.
// Hint: std::isnan does not see infinity. std::isfinite sees both.
namespace infinite_kept {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return !std::isnan(point[0]) && !std::isnan(point[1]);
}

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
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    return worth;
}

}  // namespace infinite_kept

// Says: Only the error is asked whether it is finite, but the time may be NaN or infinite, too.
// Hint: A setting with no time is no measurement.
namespace time_not_looked_at {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[1]);
}

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
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    return worth;
}

}  // namespace time_not_looked_at

// Says: Only the time is asked whether it is finite. What blew up has an error that is not.
// Hint: Ask both numbers.
namespace error_not_looked_at {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]);
}

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
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    return worth;
}

}  // namespace error_not_looked_at

// Says: Settings without any error are left out, as if nothing had been measured.
// Hint: Zero is the best error that there is.
namespace zero_left_out {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]) && point[1] > 0;
}

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
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    return worth;
}

}  // namespace zero_left_out

// Says: The places are counted from one on.
// Hint: In C++ the first element has the place 0.
namespace from_one_on {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]);
}

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
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    for (int& place : worth) ++place;
    return worth;
}

}  // namespace from_one_on

// Says: You return every setting that did not blow up, the fastest first. Nobody is thrown out.
// Hint: Go through them from the fastest on. Who takes longer must be more accurate than all before.
namespace nobody_left_out {

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> order;
    for (int i = 0; i < int(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return points[i][0] < points[j][0]; });
    return order;
}

}  // namespace nobody_left_out

// Says: The places are those in your sorted list, and not those in the list that was given.
// Hint: Sort the places by the points that they stand for, and leave the points where they are.
namespace sorted_places {

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<std::array<double, 2>> sorted;
    for (const auto& point : points)
        if (std::isfinite(point[0]) && std::isfinite(point[1])) sorted.push_back(point);
    std::sort(sorted.begin(), sorted.end());
    std::vector<int> worth;
    for (int i = 0; i < int(sorted.size()); ++i)
        if (worth.empty() || sorted[i][1] < sorted[worth.back()][1]) worth.push_back(i);
    return worth;
}

}  // namespace sorted_places

// Says: From the fastest on you keep whoever has a larger error than all before. A larger error is worse.
// Hint: Who takes longer is worth having if the error is smaller. Turn the comparison round.
namespace ever_larger_errors {

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> order;
    for (int i = 0; i < int(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return points[i] < points[j]; });
    std::vector<int> worth;
    for (const int i : order)
        if (worth.empty() || points[i][1] > points[worth.back()][1]) worth.push_back(i);
    return worth;
}

}  // namespace ever_larger_errors

// Says: Twins may change places: your sort does not keep the order of the list.
// Hint: std::sort may swap what is equal, in lists longer than a few. Which sort does not?
namespace unstable_twins {

static bool beats(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return a[0] <= b[0] && a[1] <= b[1] && (a[0] < b[0] || a[1] < b[1]);
}
std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> worth;
    for (int i = 0; i < int(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) worth.push_back(i);
    std::erase_if(worth, [&](int i) {
        return std::any_of(points.begin(), points.end(), [&](const auto& other) {
            return std::isfinite(other[0]) && std::isfinite(other[1]) && beats(other, points[i]);
        });
    });
    std::sort(worth.begin(), worth.end(), [&](int i, int j) { return points[i][0] < points[j][0]; });
    return worth;
}

}  // namespace unstable_twins

// Says: Better by a billionth or less does not count for you. If only by the last bit, better is better.
// Hint: Compare the numbers as they are, without an epsilon. Twins are equal to the last bit.
namespace nearly_equal {

static bool beats(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    const double eps = 1e-9;
    return a[0] <= b[0] + eps && a[1] <= b[1] + eps && (a[0] < b[0] - eps || a[1] < b[1] - eps);
}
std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    std::vector<int> worth;
    for (int i = 0; i < int(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) worth.push_back(i);
    std::erase_if(worth, [&](int i) {
        return std::any_of(points.begin(), points.end(), [&](const auto& other) {
            return std::isfinite(other[0]) && std::isfinite(other[1]) && beats(other, points[i]);
        });
    });
    std::stable_sort(worth.begin(), worth.end(),
                     [&](int i, int j) { return points[i][0] < points[j][0]; });
    return worth;
}

}  // namespace nearly_equal

// Says: Numbers that differ a little are the same to you: they go through float before they are compared.
// Hint: Better by the last bit is better. Compare doubles.
namespace single_precision {

using Point = std::array<double, 2>;

static bool usable(const Point& point) {
    return std::isfinite(point[0]) && std::isfinite(point[1]);
}

static bool beats(const Point& a, const Point& b) {
    return float(a[0]) <= float(b[0]) && float(a[1]) <= float(b[1]) &&
           (float(a[0]) < float(b[0]) || float(a[1]) < float(b[1]));
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

}  // namespace single_precision

// Says: Whatever was measured, you return the places of the example.
// Hint: When exactly does one setting beat another? Write that as a comparison first.
namespace example {

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    return {1, 0, 4};
}

}  // namespace example
