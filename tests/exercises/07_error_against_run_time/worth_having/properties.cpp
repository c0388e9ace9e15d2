#include "worth_having.hpp"

#include "property.hpp"

EXERCISE(worth_having);

namespace {

using Point = std::array<double, 2>;
using Points = std::vector<Point>;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

bool usable(const Point& point) { return std::isfinite(point[0]) && std::isfinite(point[1]); }

bool beats(const Point& a, const Point& b) { return usable(a) && a[0] <= b[0] && a[1] <= b[1] && a != b; }

// Every other list is drawn from few values, zero among them: they are often the same.
Points draw_points(Draw& draw, int i, int most = 30) {
    Points points(static_cast<std::size_t>(draw.integer(1, most)));
    const double second = draw.log(1e-6, 1), metre = draw.log(1e-9, 1);
    const int coarse = draw.integer(2, 8);
    for (auto& [seconds, error] : points) {
        seconds = i % 2 == 0 ? second * draw.integer(0, coarse) : draw.log(1e-6, 1e2);
        error = i % 2 == 0 ? metre * draw.integer(0, coarse) : draw.log(1e-14, 1);
    }
    return points;
}

std::size_t draw_place(Draw& draw, std::size_t size) {
    return static_cast<std::size_t>(draw.integer(0, static_cast<int>(size) - 1));
}

// Seconds of a setting that blew up: few, so that nobody is faster, or as usual, or none.
double draw_seconds(Draw& draw) { return draw.sign() > 0 ? draw.log(1e-9, 1e3) : 0; }

// The settings returned, none where an answer is not a place in the list.
Points settings(const std::vector<int>& places, const Points& points) {
    Points chosen;
    for (const int place : places) {
        if (place < 0 || place >= static_cast<int>(points.size())) return {};
        chosen.push_back(points[static_cast<std::size_t>(place)]);
    }
    return chosen;
}

// Are the same settings worth having where some that blew up stand among them?
template <class Wild>
bool changes_nothing(Draw& draw, int i, const Wild& wild) {
    Points points = draw_points(draw, i, 20);
    const Points before = settings(learner(points), points);
    for (int more = draw.integer(1, 8); more > 0; --more) {
        const auto place = static_cast<std::ptrdiff_t>(draw_place(draw, points.size() + 1));
        points.insert(points.begin() + place, wild());
    }
    const std::vector<int> worth = learner(points);
    return worth.size() == before.size() && settings(worth, points) == before;
}

}  // namespace

PROPERTY("of no settings none is worth having, and a single one that did not blow up is") {
    Draw draw;
    REQUIRE(learner({}).empty());
    for (int i = 0; i < 20; ++i) {
        REQUIRE(learner(draw_points(draw, i, 1)) == std::vector<int>{0});
    }
}

PROPERTY("what is returned are places in the list, none of them twice, the fastest first, and never nothing") {
    Draw draw;
    for (int i = 0; i < 80; ++i) {
        const Points points = draw_points(draw, i);
        const std::vector<int> worth = learner(points);
        REQUIRE(!worth.empty());
        const Points chosen = settings(worth, points);
        REQUIRE(chosen.size() == worth.size());
        for (std::size_t k = 1; k < worth.size(); ++k) {
            REQUIRE(chosen[k - 1][0] <= chosen[k][0]);
            if (chosen[k - 1] == chosen[k]) REQUIRE(worth[k - 1] < worth[k]);
        }
    }
}

PROPERTY("nobody whom you return is beaten by any other setting") {
    Draw draw;
    for (int i = 0; i < 80; ++i) {
        const Points points = draw_points(draw, i);
        const Points chosen = settings(learner(points), points);
        REQUIRE(!chosen.empty());
        for (const Point& one : chosen)
            for (const Point& other : points) REQUIRE(!beats(other, one));
    }
}

PROPERTY("everybody whom you leave out is beaten by one whom you return") {
    Draw draw;
    for (int i = 0; i < 80; ++i) {
        const Points points = draw_points(draw, i, i == 7 ? 200 : 30);
        const std::vector<int> worth = learner(points);
        const Points chosen = settings(worth, points);
        for (int place = 0; place < static_cast<int>(points.size()); ++place) {
            const Point& left_out = points[static_cast<std::size_t>(place)];
            if (std::find(worth.begin(), worth.end(), place) != worth.end()) continue;
            REQUIRE(std::any_of(chosen.begin(), chosen.end(), [&](const Point& one) { return beats(one, left_out); }));
        }
    }
}

PROPERTY("twins are both worth having, in the order of the list, or neither is") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        Points points = draw_points(draw, i, 20);
        const std::vector<int> alone = learner(points);
        const Points twice = points;
        points.insert(points.end(), twice.begin(), twice.end());
        const std::vector<int> worth = learner(points);
        REQUIRE(worth.size() == 2 * alone.size());
        for (const int place : alone) {
            const int twin = place + static_cast<int>(twice.size());
            const auto first = std::find(worth.begin(), worth.end(), place);
            REQUIRE(first != worth.end());
            REQUIRE(std::find(first, worth.end(), twin) != worth.end());
        }
    }
}

PROPERTY("settings that blew up into an infinite error are not worth having, and beat nobody") {
    Draw draw;
    REQUIRE(learner({{draw_seconds(draw), infinity}}).empty());
    for (int i = 0; i < 60; ++i) REQUIRE(changes_nothing(draw, i, [&] { return Point{draw_seconds(draw), infinity}; }));
}

PROPERTY("settings whose error is NaN are not worth having, and beat nobody") {
    Draw draw;
    REQUIRE(learner({{draw_seconds(draw), not_a_number}}).empty());
    for (int i = 0; i < 60; ++i)
        REQUIRE(changes_nothing(draw, i, [&] { return Point{draw_seconds(draw), not_a_number}; }));
}

PROPERTY("settings whose time is NaN or infinite are not worth having, and beat nobody") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double error = i % 3 == 0 ? 0 : i % 3 == 1 ? draw.log(1e-14, 1) : not_a_number;
        const double seconds = draw.sign() > 0 ? not_a_number : infinity;
        REQUIRE(learner({{seconds, error}}).empty());
        REQUIRE(changes_nothing(draw, i, [&] { return Point{seconds, error}; }));
    }
}

// From the definition in the task, for whole lists.
PROPERTY("it is right wherever the task allows: long lists, many twins, settings nearly alike, tiny ones, zeros") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 150; ++i) {
        const bool many_twins = i % 12 == 6;  // so many that a sort which may swap them does
        Points points(static_cast<std::size_t>(many_twins ? draw.integer(100, 200) : draw.integer(1, i < 50 ? 6 : 40)));
        const double second = draw.log(1e-12, 1e6), metre = draw.log(1e-15, 1e3), gap = draw.log(1e-15, 1e-2);
        const int kinds = many_twins ? 1 : draw.integer(1, 5);
        const auto number = [&](double unit) {
            const int steps = draw.integer(0, kinds);
            if (i % 3 == 0) return unit * steps;              // ties and zeros
            if (i % 3 == 1) return unit * (1 + gap * steps);  // nearly alike
            return draw.any_of(0, unit, {0, unit});
        };
        for (auto& [seconds, error] : points) seconds = number(second), error = number(metre);
        if (i % 5 == 4) points[draw_place(draw, points.size())][draw_place(draw, 2)] = i % 2 ? infinity : not_a_number;
        std::vector<int> right;
        for (int place = 0; place < static_cast<int>(points.size()); ++place) {
            const Point& one = points[static_cast<std::size_t>(place)];
            const auto beats_it = [&](const Point& other) { return beats(other, one); };
            if (usable(one) && std::none_of(points.begin(), points.end(), beats_it)) right.push_back(place);
        }
        std::stable_sort(right.begin(), right.end(), [&](int a, int b) {
            return points[static_cast<std::size_t>(a)][0] < points[static_cast<std::size_t>(b)][0];
        });
        all &= learner(points) == right;
    }
    REQUIRE(all);
}

// Who is better by the last bit, in a list of up to two hundred, and whatever the numbers: none of them is computed
// with.
PROPERTY("a last bit decides, in long lists too, for tiny numbers and for those that have all but blown up") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 60; ++i) {
        const double second = draw.spread(1e-300, 1e300, i, 20), metre = draw.spread(1e-300, 1e300, i, 19);
        const Point good{second, metre}, slow{std::nextafter(second, infinity), metre};
        const Point bad{second, std::nextafter(metre, infinity)}, both{slow[0], bad[1]};
        all &= learner({good, slow}) == std::vector<int>{0} && learner({bad, good}) == std::vector<int>{1};
        all &= learner({slow, bad}) == std::vector<int>{1, 0} && learner({both, slow}) == std::vector<int>{1};
        // Each is slower than the one before and as good, or better; every seventh is beaten by a bit.
        Points points;
        std::vector<int> right;
        for (int k = 0, n = i == 0 ? 200 : static_cast<int>(draw.spread(20, 201, i, 10)); k < n; ++k) {
            const bool beaten = k % 7 == 3;
            if (!beaten) right.push_back(k);
            const double later = points.empty() ? second : std::nextafter(points.back()[0], infinity);
            const double better = points.empty() ? metre : std::nextafter(points.back()[1], beaten ? infinity : 0.0);
            points.push_back({later, k % 7 == 4 ? std::nextafter(std::nextafter(better, 0.0), 0.0) : better});
        }
        all &= learner(points) == right;
    }
    REQUIRE(all);
}
