// What chapter 7 rests on: the contest measures what it says it measures.

#include <cmath>
#include <limits>

#include <catch2/catch_test_macros.hpp>

#include "contest/contest.hpp"

using namespace contest;

namespace {

// A scene in which the error after so many steps is what `error` says, and nothing happens in no time.
Scene scene_of(const std::function<double(long)>& error) {
    Scene scene{"scene", "a scene", 2};
    scene.reference.assign(marks, {0.0});
    Entry e{"method", "library", {}, {}, {}};
    e.track = [=](long steps) { return Track(marks, {2 * error(steps)}); };
    e.run = [](long) {};
    e.work = [](long steps) { return Work{steps, 3 * steps, 0}; };
    scene.entries.push_back(e);
    return scene;
}

constexpr Effort short_effort{30L << 6, 1, 1};

}  // namespace

TEST_CASE("what is no number has diverged, also where a number follows", "[N61][ch7]") {
    for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity(), -101.0}) {
        Scene scene = scene_of([](long) { return 0.5; });
        scene.entries[0].track = [=](long) {
            Track track(marks, {1.0});
            track[3] = {2 * wrong};
            return track;
        };
        for (const Point& p : measure(scene, short_effort)) {
            CHECK(p.diverged);
            CHECK(p.error_final == 0.5);
        }
    }
}

TEST_CASE("steps halve up to the wish, and end at the roundoff floor", "[N61][ch7]") {
    const auto order_two = [](long steps) { return 1.0 / double(steps * steps); };
    const std::vector<Point> falling = measure(scene_of(order_two), short_effort);
    REQUIRE(falling.size() == 7);  // 30, 60, … 1920
    CHECK(falling[3].error_max == order_two(240));
    CHECK(falling[3].step == duration / 240);
    CHECK(falling[3].evaluations == 720);
    const auto floor = [](long steps) { return steps < 100 ? 1e-3 : 1e-13; };
    CHECK(measure(scene_of(floor), short_effort).size() == 5);  // three at the floor
    // The same error where nothing is small is no floor.
    CHECK(measure(scene_of([](long) { return 1.0; }), short_effort).size() == 7);
}

TEST_CASE("the cheapest way to an accuracy lies between the two points that bracket it", "[N61]") {
    // Order two: half the step, twice the time, a quarter of the error.
    std::vector<Point> points;
    for (int k = 0; k < 6; ++k) {
        Point p{"scene", "method", "library"};
        p.step = 0.1 / (1 << k);
        p.error_max = 0.1 / (1 << 2 * k);
        p.seconds = 1e-6 * (1 << k);
        points.push_back(p);
    }
    const auto everyone = [](const Point&) { return true; };
    const Cheapest best = cheapest(points, 0.1 / 8, everyone);  // halfway between k = 1 and k = 2
    CHECK(std::abs(best.seconds - 1e-6 * std::sqrt(8)) < 1e-12);
    CHECK(std::abs(best.step - 0.1 / std::sqrt(8)) < 1e-9);
    CHECK(cheapest(points, 1e-9, everyone).method.empty());
}
