// Difference formulas, Taylor series, and the fit that measures an order.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Dense>
#include <timestep/difference_error.hpp>
#include <timestep/differences.hpp>
#include <timestep/measured_order.hpp>
#include <timestep/taylor.hpp>

using namespace timestep;

TEMPLATE_TEST_CASE("a difference is as good as it declares", "[differences][N08]", ForwardDifference,
                   BackwardDifference, CentralDifference, FivePointDifference) {
    const TestType formula;
    const double epsilon = std::numeric_limits<double>::epsilon();
    // Given tⁿ/n! at 0 with h = 1 a formula answers with the factor of hⁿ⁻¹ f⁽ⁿ⁾ in its Taylor
    // series. The values are at most 2ⁿ/n! ≤ 2 and there are four of them: 8 roundings of them.
    for (int n = 0; n <= TestType::order + 1; ++n) {
        const double factorial = std::tgamma(n + 1);
        const double factor = formula([=](double t) { return std::pow(t, n) / factorial; }, 0.0, 1.0);
        const double expected = n == 1 ? 1 : n <= TestType::order ? 0 : TestType::error_constant;
        INFO(formula.name << ", n = " << n);
        if (n <= TestType::order)
            CHECK(std::fabs(factor - expected) <= 8 * epsilon);
        else
            CHECK(std::fabs(std::fabs(factor) - expected) <= 8 * epsilon);
    }
    // The worst noise has the sign of each value's weight.
    double gain = 0;
    for (const double point : {-2.0, -1.0, 0.0, 1.0, 2.0})
        gain += std::fabs(formula([=](double t) { return t == point ? 1.0 : 0.0; }, 0.0, 1.0));
    CHECK(std::fabs(gain - TestType::noise_gain) <= 8 * epsilon);

    int calls = 0;
    formula([&](double t) { return ++calls, t; }, 0.0, 1.0);
    CHECK(calls == TestType::evaluations);
}

TEST_CASE("differences of vectors are vectors", "[differences]") {
    const auto circle = [](double t) { return Eigen::Vector2d(std::cos(t), std::sin(t)); };
    const double h = std::exp2(-10), epsilon = std::numeric_limits<double>::epsilon();
    const Eigen::Vector2d off = five_point_difference(circle, 0.5, h) - Eigen::Vector2d(-std::sin(0.5), std::cos(0.5));
    CHECK(off.cwiseAbs().maxCoeff() <= error_bound(five_point_difference, h, epsilon, 1));
}

TEMPLATE_TEST_CASE("the optimal step size is where the error bound is smallest", "[differences][N01]",
                   ForwardDifference, CentralDifference, FivePointDifference) {
    const TestType formula;
    for (const double noise : {1e-16, 6e-8, 0.002})
        for (const double slope : {0.3, 2.0, 40.0}) {
            const double best = best_step(formula, noise, slope);
            const double least = error_bound(formula, best, noise, slope);
            CHECK(error_bound(formula, best * 1.01, noise, slope) > least);
            CHECK(error_bound(formula, best / 1.01, noise, slope) > least);
        }
    CHECK(std::isinf(best_step(formula, 1e-16, 0)));
}

TEST_CASE("the step taken is what rounding leaves of the step", "[differences]") {
    CHECK(step_taken(1.0, 0.25) == 0.25);
    CHECK(step_taken(1.0, 1e-17) == 0);
    // After ten hours floats lie 1/256 s apart: 1/60 s becomes 4/256 s.
    CHECK(step_taken(36000.0f, 1.0f / 60) == 4.0f / 256);
    // Half of what separates floats from 2¹⁹ s on is 1/32 s, more than a frame.
    CHECK(step_taken(524288.0f, 1.0f / 60) == 0);
}

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
