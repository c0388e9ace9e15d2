// Where no mistake and no slip fits, it is told where the answer is wrong, and what it is there; and of a property both
// sides are.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <string>
#include <vector>

#include "diagnosed.hpp"
#include "property.hpp"
#include "last_comparison.hpp"

namespace {

using namespace checker;

double moved(double x, double v) { return x + 2.1 * v + 0.7; }

// The name that an answer gets, which is right but for roundoff or wrong.
template <class R>
std::string named(R (*truth)(double, double), R (*learner)(double, double), double step = 0.37) {
    std::vector<Call> calls;
    for (int i = -9; i <= 9; ++i)
        for (int j = -4; j <= 4; ++j) {
            const double x = step * i, v = step * j, found = learner(x, v);
            calls.push_back({{x, v}, {found}, std::fabs(found - truth(x, v)) < 1e-12});
        }
    return diagnosed("wrong_region_test", function_of(truth), calls);
}
std::string named(double (*learner)(double, double)) { return named(&moved, learner); }

}  // namespace

TEST_CASE("an answer that is wrong only where an argument is zero, negative or positive is told so") {
    CHECK(named([](double x, double v) { return v == 0 ? x * x + 1.1 : moved(x, v); }) == "where_zero_1");
    CHECK(named([](double x, double v) { return x < 0 ? x * v + 9.1 : moved(x, v); }) == "where_negative_0");
    CHECK(named([](double x, double v) { return v > 0 ? x * v + 9.1 : moved(x, v); }) == "where_positive_1");
}

TEST_CASE("and what it is there, where that is always so: what was given, or one whole number") {
    CHECK(named([](double x, double v) { return v == 0 ? x : moved(x, v); }) == "where_zero_1_is_given");
    CHECK(named([](double x, double v) { return x * v > 0 ? 0 : moved(x, v); }) == "is_0");
    CHECK(named([](double x, double v) { return x * v > 0 ? -1 : moved(x, v); }) == "is_-1");
    CHECK(named([](double x, double v) { return x * v > 0 ? v : moved(x, v); }) == "is_given");
}

TEST_CASE("a limit that is there for one argument is told with the least number for which it shows") {
    CHECK(named([](double x, double v) { return x >= 2 ? x * v + 9.1 : moved(x, v); }) == "where_above_0_2.22");
    CHECK(named([](double x, double v) { return x <= -2 ? x * v + 9.1 : moved(x, v); }) == "where_below_0_-2.22");
}

TEST_CASE("what is wrong everywhere, or here and there, is not told to be wrong somewhere") {
    CHECK(named([](double x, double v) { return x * v + std::cos(x) + 7.3; }).empty());
    CHECK(named([](double x, double v) { return std::sin(40 * x + 30 * v) > 0 ? x * v + 9.1 : moved(x, v); }).empty());
    CHECK(named([](double, double) { return 0.0; }).empty());
}

TEST_CASE("an answer that changes what was given twice as much, half as much or the other way is told so") {
    CHECK(named([](double x, double v) { return x + 2 * (2.1 * v + 0.7); }) == "changed_twice");
    CHECK(named([](double x, double v) { return x + (2.1 * v + 0.7) / 2; }) == "changed_half");
    CHECK(named([](double x, double v) { return x - (2.1 * v + 0.7); }) == "changed_back");
    CHECK(named([](double x, double v) { return std::fabs(moved(x, v)); }) == "absolute");
}

TEST_CASE("a yes where it should be no is told as a near thing only where all of them are") {
    const auto fits = +[](double x, double v) { return 1 + x >= v; };
    CHECK(named(
              fits, +[](double x, double v) { return 1 + x >= v - 1e-4; }, 1 + 1e-6) == "near");
    CHECK(named(
              fits, +[](double x, double v) { return 1 + x >= v - 2; }) == "is_1");
}

TEST_CASE("the sides of a property are those of the check that breaks it, with no call behind") {
    begin_comparisons();
    CHECK(checker::close(1, 1.0, 1e-9));
    keep_comparison();
    CHECK(kept_comparison().empty());
    CHECK_FALSE(checker::close(1, 1.5, 1e-9));
    forget_comparison();
    keep_comparison();
    CHECK(kept_comparison().empty());
    CHECK_FALSE(agree(false, "It is", std::complex<double>(1, 2), std::complex<double>(1, -1)));
    keep_comparison();
    CHECK(kept_comparison() == "It is 1 + 2i, and must be 1 - 1i. They differ by 3.");
    CHECK_FALSE(below("So is", 2, 1));
    keep_comparison();  // the first is told
    CHECK(kept_comparison() == "It is 1 + 2i, and must be 1 - 1i. They differ by 3.");
}
