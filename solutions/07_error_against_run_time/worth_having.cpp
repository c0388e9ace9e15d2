// Chapter 7, exercise 5: which settings are worth having
//
// You have run your game's physics with many settings, of method and step, and know of each how
// long it took and how far off it was. The options menu is to offer only those that somebody could
// want: a setting that is slower than another and no more accurate is worth nothing to anybody.
//
//   points    `{seconds, error}` of each setting, none below zero; up to 200 of them, perhaps
//             none; some settings blew up, and their error or their time is NaN or infinite
//   returns   the places in the list, from 0 on, of those worth having: the fastest first. Twins,
//             equal in seconds and in error, stand as they do in the list
//
// A setting is not worth having if another takes no more time and has no larger error, and is truly
// better in one of the two, if only by the last bit. Twins do not beat each other: both are worth
// having, or neither. What is NaN or infinite is not worth having, and beats nobody.
//
// Example: `worth_having({{3, 0.1}, {1, 0.5}, {2, 0.5}, {4, 0.1}, {5, 0}})` is `{1, 0, 4}`: the
// third takes longer than the second for the same error, and the fourth longer than the first.
//
// What is checked: no settings and single ones; what is returned is in order, and in the list once;
// nobody returned is beaten, and everybody else is; settings with the same time or the same error;
// twins; settings that blew up; errors of zero; the order of the list; other units.

#include "exercise.hpp"

std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    // [answer]
    std::vector<int> order;
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
        if (std::isfinite(points[i][0]) && std::isfinite(points[i][1])) order.push_back(i);
    // By seconds, and where these are equal by error: whoever beats a point stands before it.
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return points[i] < points[j]; });
    std::vector<int> worth;
    for (const int i : order)
        if (worth.empty() || points[i][1] < points[worth.back()][1] || points[i] == points[worth.back()])
            worth.push_back(i);
    return worth;
    // [answer]
}
