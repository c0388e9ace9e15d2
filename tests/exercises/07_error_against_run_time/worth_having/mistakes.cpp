#include "exercise.hpp"
#include <functional>

using Point = std::array<double, 2>;

static bool usable(const Point& point) { return std::isfinite(point[0]) && std::isfinite(point[1]); }
static bool beats(const Point& a, const Point& b) { return a != b && a[0] <= b[0] && a[1] <= b[1]; }
static bool takes_less_time(const Point& a, const Point& b) { return a[0] < b[0]; }
static bool faster_then_better(const Point& a, const Point& b) { return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]); }
static bool always(const Point&, const Point&) { return true; }
static bool never(const Point&, const Point&) { return false; }

// No templates of these: each mistake would have its own, and its own sort, to compile.
using Which = std::function<bool(const Point&)>;
using Relation = std::function<bool(const Point&, const Point&)>;

static std::vector<int> sorted(std::vector<int> places, const std::vector<Point>& points, const Relation& first) {
    std::stable_sort(places.begin(), places.end(), [&](int i, int j) { return first(points[i], points[j]); });
    return places;
}

// The course's answer, but for who counts, who beats whom, and who comes first.
static std::vector<int> unbeaten(const std::vector<Point>& points, const Which& counts, const Relation& beats_it,
                                 const Relation& first = faster_then_better) {
    std::vector<int> worth;
    for (int i = 0; i < int(points.size()); ++i) {
        bool beaten = !counts(points[i]);
        for (const Point& other : points)
            if (counts(other) && beats_it(other, points[i])) beaten = true;
        if (!beaten) worth.push_back(i);
    }
    return sorted(worth, points, first);
}

// Another way: from the fastest on, whom `stays(point, last that stayed)` keeps; the fastest stays in any case.
static std::vector<int> from_the_fastest_on(const std::vector<Point>& points, const Relation& stays,
                                            const Relation& first = faster_then_better) {
    std::vector<int> usable_ones, worth;
    for (int i = 0; i < int(points.size()); ++i)
        if (usable(points[i])) usable_ones.push_back(i);
    for (const int i : sorted(usable_ones, points, first))
        if (worth.empty() || stays(points[i], points[worth.back()])) worth.push_back(i);
    return worth;
}

// Says: A setting is thrown out only if another is truly better in both respects. One that is as fast and more accurate
//       beats it as well.
// Hint: Of two settings that take the same time, who would want the less accurate?
namespace worse_in_both {

std::vector<int> worth_having(const std::vector<Point>& points) {
    const auto better_in_both = [](const Point& a, const Point& b) { return a[0] < b[0] && a[1] < b[1]; };
    return unbeaten(points, usable, better_in_both, takes_less_time);
}

}  // namespace worse_in_both

// Says: A setting is thrown out as soon as another is better in one respect. Then only one that is the best in both is
//       left, and mostly there is none.
// Hint: Somebody wants speed, and somebody accuracy. Who beats another must not be worse in anything.
namespace worse_in_one {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return unbeaten(points, usable, [](const Point& a, const Point& b) { return a[0] < b[0] || a[1] < b[1]; });
}

}  // namespace worse_in_one

// Says: Nobody is worth having: your list is always empty. Is each setting compared with itself, too, which takes no
//       more time than itself?
// Hint: Take a list of a single setting: who throws it out? To beat somebody one must be truly better in something.
namespace beaten_by_itself {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return unbeaten(points, usable, [](const Point& a, const Point& b) { return a[0] <= b[0] && a[1] <= b[1]; });
}

}  // namespace beaten_by_itself

// Says: Twins throw each other out: each takes no more time than the other and has no larger error.
// Hint: No more in both is not enough. One of the two must be truly less.
namespace twins_beat_each_other {

std::vector<int> worth_having(const std::vector<Point>& points) {
    const auto no_worse = [](const Point& a, const Point& b) { return &a != &b && a[0] <= b[0] && a[1] <= b[1]; };
    return unbeaten(points, usable, no_worse);
}

}  // namespace twins_beat_each_other

// Says: Of twins you return only the first. They do not beat each other.
// Hint: What do you ask of a setting that has the same error as the best so far, and the same time?
namespace one_of_twins {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return from_the_fastest_on(points, [](const Point& point, const Point& last) { return point[1] < last[1]; });
}

}  // namespace one_of_twins

// Says: A setting that takes longer for the same error stays in: you throw out only those with a larger one.
// Hint: No more accurate than a faster one is not worth the time.
namespace same_error_kept {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return from_the_fastest_on(points, [](const Point& point, const Point& last) { return point[1] <= last[1]; });
}

}  // namespace same_error_kept

// Says: You return the fastest setting only, and its twins.
// Hint: Somebody else wants to be accurate, and is ready to wait.
namespace fastest_only {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return from_the_fastest_on(points, [](const Point& point, const Point& last) { return point == last; });
}

}  // namespace fastest_only

// Says: You return the fastest setting and the most accurate one. What lies between may be worth having, too.
// Hint: A setting need not be the best in anything. It is enough that nobody is at least as good in both.
namespace ends_only {

std::vector<int> worth_having(const std::vector<Point>& points) {
    const std::vector<int> worth = unbeaten(points, usable, beats);
    std::vector<int> ends;
    for (const int i : worth)
        if (points[i] == points[worth.front()] || points[i] == points[worth.back()]) ends.push_back(i);
    return ends;
}

}  // namespace ends_only

// Says: The larger error wins in your comparison.
// Hint: An error is better if it is smaller.
namespace error_upside_down {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return unbeaten(points, usable, [](const Point& a, const Point& b) { return beats({a[0], -a[1]}, {b[0], -b[1]}); });
}

}  // namespace error_upside_down

// Says: You return those that are beaten.
// Hint: Turn the decision round. What blew up stays out in any case.
namespace the_others {

std::vector<int> worth_having(const std::vector<Point>& points) {
    const std::vector<int> best = unbeaten(points, usable, beats);
    std::vector<int> others;
    for (const int place : from_the_fastest_on(points, always, takes_less_time))
        if (std::find(best.begin(), best.end(), place) == best.end()) others.push_back(place);
    return others;
}

}  // namespace the_others

// Says: Settings that blew up are worth having to you: no comparison with NaN is true, so nobody beats it; and an
//       infinite error that came fast is not beaten either.
// Hint: Sort out what is not finite before you compare: std::isfinite of both numbers.
namespace blown_up_kept {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return unbeaten(points, [](const Point&) { return true; }, beats);
}

}  // namespace blown_up_kept

// Says: NaN is sorted out, but not infinity: a setting that was fast and is infinitely far off is offered.
// Hint: std::isnan does not see infinity. std::isfinite sees both.
namespace infinite_kept {

std::vector<int> worth_having(const std::vector<Point>& points) {
    const auto is_number = [](const Point& point) { return !std::isnan(point[0]) && !std::isnan(point[1]); };
    return unbeaten(points, is_number, beats);
}

}  // namespace infinite_kept

// Says: Only the error is asked whether it is finite, but the time may be NaN or infinite, too.
// Hint: A setting with no time is no measurement.
namespace time_not_looked_at {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return unbeaten(points, [](const Point& point) { return std::isfinite(point[1]); }, beats);
}

}  // namespace time_not_looked_at

// Says: Only the time is asked whether it is finite. What blew up has an error that is not.
// Hint: Ask both numbers.
namespace error_not_looked_at {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return unbeaten(points, [](const Point& point) { return std::isfinite(point[0]); }, beats);
}

}  // namespace error_not_looked_at

// Says: Settings without any error are left out, as if nothing had been measured.
// Hint: Zero is the best error that there is.
namespace zero_left_out {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return unbeaten(points, [](const Point& point) { return usable(point) && point[1] > 0; }, beats);
}

}  // namespace zero_left_out

// Says: You return every setting that did not blow up, the fastest first. Nobody is thrown out.
// Hint: Go through them from the fastest on. Who takes longer must be more accurate than all before.
namespace nobody_left_out {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return from_the_fastest_on(points, always, takes_less_time);
}

}  // namespace nobody_left_out

// Says: From the fastest on you keep whoever has a larger error than all before. A larger error is worse.
// Hint: Who takes longer is worth having if the error is smaller. Turn the comparison round.
namespace ever_larger_errors {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return from_the_fastest_on(points, [](const Point& point, const Point& last) { return point[1] > last[1]; });
}

}  // namespace ever_larger_errors

// Says: Better by a billionth or less does not count for you. If only by the last bit, better is better.
// Hint: Compare the numbers as they are, without an epsilon. Twins are equal to the last bit.
namespace nearly_equal {

std::vector<int> worth_having(const std::vector<Point>& points) {
    const auto beats_clearly = [](const Point& a, const Point& b) {
        const double eps = 1e-9;
        return a[0] <= b[0] + eps && a[1] <= b[1] + eps && (a[0] < b[0] - eps || a[1] < b[1] - eps);
    };
    return unbeaten(points, usable, beats_clearly, takes_less_time);
}

}  // namespace nearly_equal

// Says: Numbers that differ a little are the same to you: they go through float before they are compared.
// Hint: Better by the last bit is better. Compare doubles.
namespace single_precision {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return unbeaten(points, usable, [](const Point& a, const Point& b) {
        return beats({float(a[0]), float(a[1])}, {float(b[0]), float(b[1])});
    });
}

}  // namespace single_precision

// Says: Whatever was measured, you return the places of the example.
// Hint: When exactly does one setting beat another? Write that as a comparison first.
namespace example {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return {1, 0, 4};
}

}  // namespace example

// Says: You sort by the seconds alone, and keep whoever has a smaller error than all before. Of settings with the same time
//       the less accurate stays if it comes first, and of twins only one does.
// Hint: Two cases are open. Where the seconds are equal, who must come first? And a twin of the last one kept?
namespace ties_in_time {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return from_the_fastest_on(points, [](const Point& point, const Point& last) { return point[1] < last[1]; }, takes_less_time);
}

}  // namespace ties_in_time

// Says: You sort by the seconds alone, in no order where they are equal, and keep whoever has a smaller error than all before.
//       A less accurate setting with the same time may come first, and stays; and of twins only one does.
// Hint: Compare the errors, too, where the seconds are equal. And what do you do with a twin of the last one kept?
namespace ties_in_any_order {

std::vector<int> worth_having(const std::vector<Point>& points) {
    std::vector<int> order, worth;
    for (int i = 0; i < int(points.size()); ++i)
        if (usable(points[i])) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](int i, int j) { return points[i][0] < points[j][0]; });
    for (const int i : order)
        if (worth.empty() || points[i][1] < points[worth.back()][1]) worth.push_back(i);
    return worth;
}

}  // namespace ties_in_any_order

// Says: Two things are wrong: where the seconds are equal the less accurate setting may come first, and stays; and one that
//       takes longer for the same error stays, too.
// Hint: Sort by the errors where the seconds are equal. Then who takes longer must have a smaller error, not the same.
namespace ties_in_time_and_same_error {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return from_the_fastest_on(points, [](const Point& point, const Point& last) { return point[1] <= last[1]; }, takes_less_time);
}

}  // namespace ties_in_time_and_same_error
