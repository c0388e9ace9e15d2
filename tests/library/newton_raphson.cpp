// Newton–Raphson finds roots, and ends even where there is none.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <Eigen/Dense>
#include <timestep/newton_raphson.hpp>

using namespace timestep;

TEMPLATE_TEST_CASE("a square root, to the last digits of its type", "[library]", float, double, long double) {
    const TestType epsilon = std::numeric_limits<TestType>::epsilon();
    const TestType root = newton_raphson(
                              TestType(1), [](TestType x) { return x * x - 2; }, [](TestType x) { return 2 * x; })
                              .x;
    // x² − 2 near the root is known to 2ε (x² rounds by ε, the difference is exact); dividing it by
    // 2x puts x within ε of the root, and rounding x adds another ε.
    CHECK(std::fabs(root - std::sqrt(TestType(2))) <= 2 * epsilon);
}

TEST_CASE("a linear function needs one correction, and a second one to see that it is done", "[library]") {
    int evaluations = 0;
    const double root = newton_raphson(
                            100.0, [&](double x) { return ++evaluations, 2 * x - 6; }, [](double) { return 2.0; })
                            .x;
    CHECK(root == 3);
    CHECK(evaluations == 2);
}

TEST_CASE("a function that rises everywhere is solved from anywhere", "[library]") {
    // The tangents of atan lead away from its root for |x| > 1.39, those of x + 1.99 sin x / 2 round
    // in circles.
    for (const double x : {0.1, 1.4, 3.0, 1e3, -1e6}) {
        const auto [root, found] = newton_raphson(
            x, [](double u) { return std::atan(u); }, [](double u) { return 1 / (1 + u * u); });
        CHECK(found);
        CHECK(std::fabs(root) < 1e-15 * std::fabs(x));
        const auto [other, too] = newton_raphson(
            x, [](double u) { return u + 0.999 * std::sin(u) - 2; }, [](double u) { return 1 + 0.999 * std::cos(u); });
        CHECK(too);
        // Rounding at the size of the start stays; the slope is 0.5 at the root, 1.18.
        CHECK(std::fabs(other + 0.999 * std::sin(other) - 2) <
              8 * std::numeric_limits<double>::epsilon() * std::fmax(2, std::fabs(x)));
    }
}

// A correction that leads out of the numbers: √x has none below zero.
TEST_CASE("a step to where the function is no number is halved, too", "[library]") {
    const double root =
        newton_raphson(
            4.0, [](double x) { return std::sqrt(x) - 0.01; }, [](double x) { return 0.5 / std::sqrt(x); })
            .x;
    CHECK(std::fabs(root - 1e-4) < 64 * std::numeric_limits<double>::epsilon());
}

// Half of infinity is infinity: halving it would never end.
TEST_CASE("where f(x) or the correction is too large it ends with a NaN", "[library]") {
    using V = Eigen::Vector2d;
    const double inf = std::numeric_limits<double>::infinity();
    int evaluations = 0;
    const auto few = [&] {
        if (++evaluations > 1000) throw std::runtime_error("no end");
    };
    const auto root = [&](double f, double slope) {
        return newton_raphson(
                   1.0, [&](double) { return few(), f; }, [&](double) { return slope; })
            .x;
    };
    CHECK(std::isnan(root(inf, 2)));
    CHECK(std::isnan(root(1e300, 1e-10)));
    CHECK(std::isnan(root(1, 0)));
    // In a vector whose length is no number, too.
    evaluations = 0;
    const V x = newton_raphson(
                    V(1, 1), [&](const V&) { return few(), V(1.7e308, 1.7e308); },
                    [](const V&) { return Eigen::Matrix2d(Eigen::Matrix2d::Identity()); })
                    .x;
    CHECK(x.hasNaN());
}

TEST_CASE("it says whether what it returns is a root", "[library]") {
    // x² + c has its least size at zero: a root for c ≤ 0, none above. A stiff spring at rest, whose
    // terms cancel to their roundoff, has one.
    const auto ends = [](double from, double c) {
        return newton_raphson(
            from, [=](double x) { return x * x + c; }, [](double x) { return 2 * x; });
    };
    for (const double from : {0.7, 3.0, 1e3}) {
        CHECK(ends(from, -2).found);
        for (const double c : {1e-6, 1.0, 100.0}) CHECK_FALSE(ends(from, c).found);
    }
    for (const double omega2 : {1e4, 1e8, 1e12}) {
        const double h = 1.0 / 60, g = 9.81, x0 = -g / omega2;
        const auto v = newton_raphson(
            0.01, [=](double v) { return v - h * (-omega2 * (x0 + h * v) - g); },
            [=](double) { return 1 + h * h * omega2; });
        CHECK(v.found);
        CHECK(std::fabs(v.x) < 1e-12);
    }
}

// Implicit Euler's equation for a pendulum's new velocity. Its angle rounds by ε times its size, which moves the root
// by that over h: far more than the roundoff of the velocity.
TEST_CASE("after hundreds of turns of a pendulum Newton-Raphson reports that it has found the root", "[library]") {
    const double h = 1.0 / 60, pull = 0.9 / h;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> from(-1, 1);
    long solved = 0, known = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double x1 = 6283 * from(random), v1 = std::pow(10, 3 * from(random)) * from(random);
        const auto missing = [&](double v) { return v - v1 + pull * std::sin(x1 + h * v); };
        const auto [v, found] =
            newton_raphson(v1, missing, [&](double u) { return 1 + h * pull * std::cos(x1 + h * u); });
        // The sum's roundoff, and the angle's, which the sine passes on.
        const double roundoff = 4 * std::numeric_limits<double>::epsilon() *
                                (std::fabs(v1) + std::fabs(v) + pull * (1 + std::fabs(x1) + h * std::fabs(v)));
        const bool is_root = std::fabs(missing(v)) <= roundoff;
        solved += is_root, known += is_root && found;
        REQUIRE((is_root || !found));
    }
    CHECK(solved > 18'000);
    CHECK(known == solved);
}
