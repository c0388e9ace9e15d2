// What chapter 7 rests on: the contest measures what it says it measures.

#include <catch2/catch_test_macros.hpp>

#include "../../chapters/07_error_against_run_time/contest.hpp"

using namespace contest;

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
