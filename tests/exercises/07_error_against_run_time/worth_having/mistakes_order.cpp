// In which order the settings stand, and where in the list.

// Says: You have sorted by the seconds alone. Of settings with the same time the less accurate may come first, and
//       stays.
// Hint: Where the seconds are equal, who must come first so that it can throw out the other?
namespace same_time_kept {

std::vector<int> worth_having(const std::vector<Point>& points) {
    const auto better_or_twin = [](const Point& a, const Point& last) { return a[1] < last[1] || a == last; };
    return from_the_fastest_on(points, better_or_twin, takes_less_time);
}

}  // namespace same_time_kept

// Says: Each setting is compared with the next faster one only. That one may itself be bad, and a third beat both.
// Hint: Keep in mind the least error of all that are faster.
namespace neighbours_only {

std::vector<int> worth_having(const std::vector<Point>& points) {
    const std::vector<int> order = from_the_fastest_on(points, always);
    std::vector<int> worth;
    for (std::size_t k = 0; k < order.size(); ++k)
        if (k == 0 || points[order[k]][1] < points[order[k - 1]][1] || points[order[k]] == points[order[k - 1]])
            worth.push_back(order[k]);
    return worth;
}

}  // namespace neighbours_only

// Says: The right settings, but as they stand in the list: the fastest does not come first.
// Hint: Sort the places at the end, by the seconds of their points.
namespace list_order {

std::vector<int> worth_having(const std::vector<Point>& points) {
    return unbeaten(points, usable, beats, never);
}

}  // namespace list_order

// Says: The right settings, but the slowest first.
// Hint: Sort the other way round; twins stay as they stand in the list.
namespace slowest_first {

std::vector<int> worth_having(const std::vector<Point>& points) {
    const auto slower = [](const Point& a, const Point& b) { return faster_then_better(b, a); };
    return unbeaten(points, usable, beats, slower);
}

}  // namespace slowest_first

// Says: The places are counted from one on.
// Hint: In C++ the first element has the place 0.
namespace from_one_on {

std::vector<int> worth_having(const std::vector<Point>& points) {
    std::vector<int> worth = unbeaten(points, usable, beats);
    for (int& place : worth) ++place;
    return worth;
}

}  // namespace from_one_on

// Says: The places are those in your sorted list, and not those in the list that was given.
// Hint: Sort the places by the points that they stand for, and leave the points where they are.
namespace sorted_places {

std::vector<int> worth_having(const std::vector<Point>& points) {
    const std::vector<int> order = from_the_fastest_on(points, always);
    std::vector<int> worth;
    for (int k = 0; k < int(order.size()); ++k)
        if (worth.empty() || points[order[k]][1] < points[order[worth.back()]][1]) worth.push_back(k);
    return worth;
}

}  // namespace sorted_places

// Says: Twins may change places: your sort does not keep the order of the list.
// Hint: std::sort may swap what is equal, in lists longer than a few. Which sort does not?
namespace unstable_twins {

std::vector<int> worth_having(const std::vector<Point>& points) {
    std::vector<int> worth = unbeaten(points, usable, beats, never);
    std::sort(worth.begin(), worth.end(), [&](int i, int j) { return points[i][0] < points[j][0]; });
    return worth;
}

}  // namespace unstable_twins

// Says: The numbers are places in a list that you have sorted yourself, without what is not finite. The caller has
//       another list.
// Hint: Sort the places, not the settings: then each of them still says where it stood.
namespace places_when_sorted {

std::vector<int> worth_having(const std::vector<Point>& points) {
    std::vector<Point> settings;
    for (const Point& point : points)
        if (usable(point)) settings.push_back(point);
    std::stable_sort(settings.begin(), settings.end(), faster_then_better);
    return unbeaten(settings, usable, beats);
}

}  // namespace places_when_sorted
