// Taylor series, and the fit that measures an order.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/taylor.hpp>

using namespace timestep;

TEMPLATE_TEST_CASE("a Taylor series with all its terms is the polynomial itself", "[taylor][N09]", float, double,
                   long double) {
    // 2 − x + 3x² + x³/2 and its derivatives at 1
    const auto polynomial = [](TestType x) { return 2 - x + 3 * x * x + x * x * x / 2; };
    const std::array<TestType, 4> at_1{TestType(4.5), TestType(6.5), 9, 3};
    for (TestType h = -2; h <= 2; h += TestType(0.125)) {
        const TestType expected = polynomial(1 + h);
        // Terms up to 4.5 + 13 + 18 + 4 = 40, rounded a dozen times on either side.
        CHECK(std::fabs(taylor(std::span<const TestType, 4>(at_1), h) - expected) <=
              24 * 40 * std::numeric_limits<TestType>::epsilon() / 2);
    }
}

TEST_CASE("a Taylor series of no terms is zero, of one term the value here", "[taylor]") {
    const std::array<double, 2> terms{3, 7};
    const std::span<const double> all(terms);
    CHECK(taylor(all.first(0), 0.5) == 0);
    CHECK(taylor(all.first(1), 0.5) == 3);
    CHECK(taylor(all, 0.5) == 6.5);
}

TEST_CASE("the measured order of C h^p is p", "[measured_order]") {
    for (const double p : {1.0, 2.0, 4.0, 0.5}) {
        std::vector<double> steps, errors;
        for (int i = 0; i < 10; ++i) {
            steps.push_back(std::exp2(-i));
            errors.push_back(3 * std::pow(steps.back(), p));
        }
        // Logarithms up to 30, right to ε, over a spread of 6: far below 1e-13.
        CHECK(std::fabs(measured_order(steps, errors) - p) <= 1e-13);
    }
}

TEST_CASE("an order that cannot be measured is not a number", "[measured_order]") {
    CHECK(std::isnan(measured_order({}, {})));
    CHECK(std::isnan(measured_order({0.1}, {0.2})));
    CHECK(std::isnan(measured_order({0.1, 0.1}, {0.2, 0.3})));
    for (std::size_t n = 3; n <= 10; ++n) {
        std::vector<double> errors(n, 0.2);
        errors[0] = 0.3;
        CHECK(std::isnan(measured_order(std::vector<double>(n, 0.7), errors)));
    }
    CHECK(std::isnan(measured_order({0.1, 0.2}, {0.2, 0.0})));
    CHECK(std::isnan(measured_order({0.1, 0.2}, {0.2, 0.3, 0.4})));
}
