// The claims of chapter 1, one claim of the talks after the other.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <timestep/difference_error.hpp>
#include <timestep/differences.hpp>
#include <timestep/taylor.hpp>

using namespace timestep;

namespace {

template <class Real>
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

const auto exponential = [](auto x) { return std::exp(x); };
const auto sine = [](auto x) { return std::sin(x); };

}  // namespace

TEST_CASE("an exponential's slope is the exponential times its rate, growing or decaying", "[N04][ch1]") {
    const double h = std::exp2(-10);
    for (const double a : {1.0, 1.5, -1.5, -0.25}) {
        const auto f = [a](double x) { return std::exp(a * x); };
        for (int i = -64; i <= 32; ++i) {
            const double x = i / 32.0;  // −2 … 1
            // The third derivative is a³f, largest at one end. a·x is rounded by ε/2 · 3, exp to ε.
            const double most = std::max(f(x - h), f(x + h));
            const double bound =
                error_bound(central_difference, h, 2.5 * epsilon<double> * most, std::fabs(a * a * a) * most);
            CHECK(std::fabs(central_difference(f, x, h) - a * f(x)) <= bound);
        }
    }
}

TEST_CASE("a sine's slope is a cosine", "[N05][ch1]") {
    const double h = std::exp2(-10);
    for (int i = 0; i <= 402; ++i) {
        const double x = i / 64.0;  // 0 … 2π
        // |f‴| ≤ 1, values below 1 right to ε
        CHECK(std::fabs(central_difference(sine, x, h) - std::cos(x)) <=
              error_bound(central_difference, h, epsilon<double>, 1));
    }
}

TEST_CASE("one dot is the slope of the position, two dots the slope of the slope", "[N06][ch1]") {
    const double h = std::exp2(-10);
    const auto x = [](double t) { return 0.5 * std::sin(2 * t); };
    const auto x_dot = [&](double t) { return central_difference(x, t, h); };
    const auto x_dot_dot = [&](double t) { return central_difference(x_dot, t, h); };
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 64.0;
        // x⃛ is at most 4. Written out, the second one is (x(t + 2h) − 2x(t) + x(t − 2h))/(4h²),
        // which leaves out (2h)²/12 x⁗ with x⁗ ≤ 8; four values, each right to ε/2.
        CHECK(std::fabs(x_dot(t) - std::cos(2 * t)) <= error_bound(central_difference, h, epsilon<double> / 2, 4));
        CHECK(std::fabs(x_dot_dot(t) - (-4 * x(t))) <=
              4 * h * h / 12 * 8 + 4 * (epsilon<double> / 2) / (4 * h * h) + 2 * epsilon<double> / h);
    }
}

TEMPLATE_TEST_CASE("the first-order Taylor series with the forward difference in it is exact", "[N10][ch1]", float,
                   double, long double) {
    for (int i = 1; i <= 200; ++i) {
        const TestType x = static_cast<TestType>(std::sin(i) * 2);
        const TestType h = static_cast<TestType>(std::exp2(-i % 10));
        const TestType now = std::exp(x), after = std::exp(x + h);
        // x₂ = x₁ + h ẋ solved for ẋ, and put back: difference, quotient, product and sum are
        // rounded by ε/2 each, the first three of x₂ − x₁, the last of x₂.
        const std::array<TestType, 2> chord{now, forward_difference(exponential, x, h)};
        const TestType rounding = epsilon<TestType> / 2 * (3 * std::fabs(after - now) + after);
        CHECK(std::fabs(taylor(std::span<const TestType, 2>(chord), h) - after) <= 1.01 * rounding);
        // With the exact slope the series misses by what the forward difference errs, times h.
        const std::array<TestType, 2> tangent{now, now};
        const TestType missed = after - taylor(std::span<const TestType, 2>(tangent), h);
        const TestType error = forward_difference(exponential, x, h) - now;
        CHECK(std::fabs(missed - h * error) <= 8 * epsilon<TestType> * after);
    }
}
