// The claims of chapter 1, one claim of the talks after the other.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <timestep/difference_error.hpp>
#include <timestep/differences.hpp>
#include <timestep/measured_order.hpp>
#include <timestep/taylor.hpp>

using namespace timestep;
using Catch::Matchers::WithinAbs;

namespace {

template <class Real>
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

// One term of a formula's error: factor · h^power.
struct Term {
    int power;
    double factor;
};

// A function at x with its size and slope there, and the first two error terms of a formula on it.
template <class Function>
struct Case {
    Function f;
    double x, size, slope;
    Term leading, next;
};
template <class Function>
Case(Function, double, double, double, Term, Term) -> Case<Function>;

// The order of a formula at a case, measured at steps where it can be seen:
//  at the top the next term turns the local order by 0.02 (for leading · hᵖ + next · hᵖ⁺ᵐ that is
//  m · next/leading · hᵐ);
//  at the bottom the noise (one last digit a value, ε|f|, also for x³ and its two roundings) is 1 %
//  of the error, which turns a line fitted over a factor of 4 or more by at most 0.01 · 2/ln 4.
// Together that is less than the 0.05 asked for.
template <class Real, class Formula, class Function>
double order_of(const Formula& formula, const Case<Function>& c) {
    const int p = c.leading.power, m = c.next.power - p;
    const double ratio = c.next.factor / c.leading.factor;
    const double high = ratio > 0 ? std::min(0.5, std::pow(0.02 / (m * ratio), 1.0 / m)) : 0.5;
    const double noise = formula.noise_gain * epsilon<Real> * c.size;
    const double low = std::pow(100 * noise / c.leading.factor, 1.0 / (p + 1));
    REQUIRE(high > 4 * low);
    std::vector<double> steps, errors;
    for (int i = 0; i <= 24; ++i) {
        const Real x = static_cast<Real>(c.x);
        const Real h = step_taken(x, static_cast<Real>(low * std::pow(high / low, i / 24.0)));
        const long double error = formula(c.f, x, h) - static_cast<long double>(c.slope);
        steps.push_back(static_cast<double>(h));
        errors.push_back(static_cast<double>(std::fabs(error)));
    }
    return measured_order(steps, errors);
}

const auto exponential = [](auto x) { return std::exp(x); };
const auto sine = [](auto x) { return std::sin(x); };
const auto cube = [](auto x) { return x * x * x; };
const double e = std::exp(1.0), sin1 = std::sin(1.0), cos1 = std::cos(1.0);

// The largest error of the forward difference of eˣ over a thousand neighbours of 1.
template <class Real>
double largest_error(double h) {
    double largest = 0;
    for (int i = 0; i < 1000; ++i) {
        const Real x = static_cast<Real>(1 + i * 1e-5);
        const long double slope = forward_difference(exponential, x, step_taken(x, static_cast<Real>(h)));
        const long double error = slope - std::exp(static_cast<long double>(x));
        largest = std::max(largest, static_cast<double>(std::fabs(error)));
    }
    return largest;
}

}  // namespace

TEMPLATE_TEST_CASE("the chord's slope comes to the tangent's with order 1", "[N01][N07][ch1]", float, double) {
    // h/2 f″ and h²/6 f‴, in size
    const Case on_exp{exponential, 1, e, e, {1, e / 2}, {2, e / 6}};
    const Case on_sin{sine, 1, sin1, cos1, {1, sin1 / 2}, {2, cos1 / 6}};
    const Case on_cube{cube, 1, 1, 3, {1, 3}, {2, 1}};
    CHECK_THAT(order_of<TestType>(forward_difference, on_exp), WithinAbs(1, 0.05));
    CHECK_THAT(order_of<TestType>(forward_difference, on_sin), WithinAbs(1, 0.05));
    CHECK_THAT(order_of<TestType>(forward_difference, on_cube), WithinAbs(1, 0.05));
    CHECK_THAT(order_of<TestType>(backward_difference, on_exp), WithinAbs(1, 0.05));
    CHECK_THAT(order_of<TestType>(backward_difference, on_sin), WithinAbs(1, 0.05));
    CHECK_THAT(order_of<TestType>(backward_difference, on_cube), WithinAbs(1, 0.05));
}

TEST_CASE("where the second derivative is zero the chord's slope has order 2", "[N01][ch1]") {
    // sin at 0: h²/6 f‴ and h⁴/120 f⁽⁵⁾, in size; sin is at most 0.5 at the steps used.
    const Case flat{sine, 0, 0.5, 1, {2, 1.0 / 6}, {4, 1.0 / 120}};
    CHECK_THAT(order_of<double>(forward_difference, flat), WithinAbs(2, 0.05));
}

TEMPLATE_TEST_CASE("the chord's error stays below truncation plus rounding at every step", "[N01][ch1]", float, double,
                   long double) {
    const TestType x = 1;
    const long double exact = std::exp(1.0L);
    for (TestType h = 0.5; step_taken(x, h) == h; h /= 2) {
        // f″ is at most e^(1 + h) on the chord; values are right to one last digit, ε e^(1 + h);
        // the subtraction and the quotient are rounded too, by ε/2 each.
        const double most = std::exp(1 + static_cast<double>(h));
        const double eps = static_cast<double>(epsilon<TestType>);
        const double bound = error_bound(forward_difference, static_cast<double>(h), eps * most, most) + eps * most;
        const long double error = std::fabs(forward_difference(exponential, x, h) - exact);
        INFO("h = " << h);
        CHECK(static_cast<double>(error) <= bound);
    }
}

TEMPLATE_TEST_CASE("below the square root of epsilon the chord's error rises again", "[N01][ch1]", float, double) {
    // At h = √ε truncation and rounding are at most (e/2 + 2e) √ε together, the values being right
    // to one digit. At √ε/32 the slopes that the rounded values allow lie ulp/h = 64 √ε apart, so
    // among neighbours whose exact slope goes through several of them one errs by nearly 32 √ε.
    const double h = std::sqrt(static_cast<double>(epsilon<TestType>));
    const double at_root = largest_error<TestType>(h);
    CHECK(at_root <= 2.5 * e * 1.02 * h);  // e grows by 1 % on the way to the last neighbour
    CHECK(largest_error<TestType>(h / 32) > 4 * at_root);
}

TEMPLATE_TEST_CASE("a line has one slope, a horizontal line none", "[N02][ch1]", float, double, long double) {
    const auto line = [](auto x) { return x / 2 + 1; };
    const auto level = [](auto x) { return 0 * x + 5 / static_cast<TestType>(3); };
    for (int i = 0; i <= 500; ++i) {
        const TestType x = static_cast<TestType>(-1 + i / 100.0);
        for (TestType h = static_cast<TestType>(1 / 3.0); h > 10 * epsilon<TestType>; h /= 3) {
            // Two values are rounded (ε/2 of each), x + h is (ε/2 of it, and |x + h| ≤ 2f), and so
            // is the quotient: at most 2.75 ε|f|/h, since f(x + h) ≤ 2 f(x) here.
            CHECK(std::fabs(forward_difference(line, x, h) - TestType(0.5)) <= 4 * epsilon<TestType> * line(x) / h);
            CHECK(forward_difference(level, x, h) == 0);
        }
    }
}

TEMPLATE_TEST_CASE("a parabola's slopes lie on a line, and the central difference finds them", "[N03][ch1]", float,
                   double, long double) {
    for (const double factor : {1.0, -2.5, 0.3}) {
        const TestType a = static_cast<TestType>(factor);
        const auto parabola = [a](TestType x) { return a * x * x; };
        for (int i = -8; i <= 8; ++i) {
            const TestType x = i / TestType(8);  // so that x ± h is exact
            for (TestType h = 0.5; h > 1e-3; h /= 2) {
                // Two roundings a value, (|x| + h)² ≤ 2.25 where |f| is largest.
                const TestType largest = std::fabs(parabola(std::fabs(x) + h));
                const TestType slope = central_difference(parabola, x, h);
                CHECK(std::fabs(slope - 2 * a * x) <= 4 * epsilon<TestType> * largest / h);
                // The tangent with that slope parts from the curve by a (distance)².
                const TestType away = TestType(0.25);
                const TestType tangent = parabola(x) + slope * away;
                const TestType rounding =
                    8 * epsilon<TestType> * largest * (1 + away / h) + 4 * epsilon<TestType> * std::fabs(a);
                CHECK(std::fabs(parabola(x + away) - tangent - a * away * away) <= rounding);
            }
        }
    }
}

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

TEMPLATE_TEST_CASE("the backward difference is the forward one with the step turned round", "[N07][ch1]", float, double,
                   long double) {
    for (int i = 1; i <= 200; ++i) {
        const TestType x = static_cast<TestType>(std::sin(i) * 5);
        const TestType h = static_cast<TestType>(std::exp(-i % 12) / 3);
        CHECK(backward_difference(sine, x, h) == forward_difference(sine, x, -h));
        CHECK(forward_difference(exponential, x, h) == backward_difference(exponential, x, -h));
    }
}

TEST_CASE("on a hilltop the forward difference is too low and the backward one too high", "[N07][ch1]") {
    // sin bends down between 0 and π: the error is h/2 f″ at some point of the chord.
    for (const double x : {0.7, 1.2, 2.0, 2.4})
        for (const double h : {0.5, 0.1, 0.01}) {
            const double exact = std::cos(x);
            const double ahead = exact - forward_difference(sine, x, h);
            const double behind = backward_difference(sine, x, h) - exact;
            const auto [low, high] = std::minmax({std::sin(x), std::sin(x + h), std::sin(x - h)});
            const double rounding = 3 * epsilon<double> / h;
            const double top = x - h < 1.58 && x + h > 1.57 ? 1 : high;  // the hilltop is within reach
            CHECK(ahead >= h / 2 * low - rounding);
            CHECK(ahead <= h / 2 * top + rounding);
            CHECK(behind >= h / 2 * low - rounding);
            CHECK(behind <= h / 2 * top + rounding);
        }
}

TEMPLATE_TEST_CASE("the central difference has order 2", "[N08][ch1]", float, double) {
    // h²/6 f‴ and h⁴/120 f⁽⁵⁾, in size
    const Case on_exp{exponential, 1, e, e, {2, e / 6}, {4, e / 120}};
    const Case on_sin{sine, 1, sin1, cos1, {2, cos1 / 6}, {4, cos1 / 120}};
    const Case on_cube{cube, 1, 1, 3, {2, 1}, {4, 0}};
    CHECK_THAT(order_of<TestType>(central_difference, on_exp), WithinAbs(2, 0.05));
    CHECK_THAT(order_of<TestType>(central_difference, on_sin), WithinAbs(2, 0.05));
    CHECK_THAT(order_of<TestType>(central_difference, on_cube), WithinAbs(2, 0.05));
}

TEST_CASE("the five-point difference has order 4", "[N08][ch1]") {
    // h⁴/30 f⁽⁵⁾ and h⁶/252 f⁽⁷⁾, in size. In float no step shows it: rounding reaches too far up.
    const Case on_exp{exponential, 1, e, e, {4, e / 30}, {6, e / 252}};
    const Case on_sin{sine, 1, sin1, cos1, {4, cos1 / 30}, {6, cos1 / 252}};
    CHECK_THAT(order_of<double>(five_point_difference, on_exp), WithinAbs(4, 0.05));
    CHECK_THAT(order_of<double>(five_point_difference, on_sin), WithinAbs(4, 0.05));
}

TEST_CASE("the five-point difference is exact on a cubic and on a quartic", "[N08][ch1]") {
    // Values up to 16 on [−2, 2], right to two digits each, and nothing left out.
    const auto quartic = [](double x) { return x * x * x * x; };
    for (const double x : {-1.0, -0.5, 0.0, 0.75, 1.0})
        for (const double h : {0.5, 0.25, 0.125}) {
            const double rounding = error_bound(five_point_difference, h, 32 * epsilon<double>, 0);
            CHECK(std::fabs(five_point_difference(cube, x, h) - 3 * x * x) <= rounding);
            CHECK(std::fabs(five_point_difference(quartic, x, h) - 4 * x * x * x) <= rounding);
        }
}

TEST_CASE("positions on a grid give a velocity within truncation plus noise", "[N07][N08][ch1]") {
    // x = ½ sin 2t: |ẍ| ≤ 2, and the third derivative is at most 4. Times up to 10 s are rounded by
    // less than 1e-15 s and positions by less: together far below 1e-14.
    const double grid = 0.004;
    const auto received = [=](double t) { return grid * std::round(0.5 * std::sin(2 * t) / grid); };
    for (int frames = 1; frames <= 30; ++frames) {
        const double gap = frames / 60.0, rounding = 1e-14 / gap;
        double now = 0, between = 0;
        for (int i = 0; i < 600; ++i) {
            const double t = i / 60.0, middle = t - gap / 2;
            now = std::max(now, std::fabs(backward_difference(received, t, gap) - std::cos(2 * t)));
            between =
                std::max(between, std::fabs(central_difference(received, middle, gap / 2) - std::cos(2 * middle)));
        }
        CHECK(now <= error_bound(backward_difference, gap, grid / 2, 2) + rounding);
        CHECK(between <= error_bound(central_difference, gap / 2, grid / 2, 4) + rounding);
    }
}

TEST_CASE("subtracting two second-order Taylor series leaves the central difference", "[N08][ch1]") {
    const double x = 0.8;
    const std::array<double, 3> terms{std::sin(x), std::cos(x), -std::sin(x)};
    const std::span<const double, 3> here(terms);
    for (const double h : {1.0, 0.25, 0.01}) {
        // As functions of the step the two series agree in f and f″, which cancel.
        const double slope = (taylor(here, h) - taylor(here, -h)) / (2 * h);
        CHECK(std::fabs(slope - std::cos(x)) <= 4 * epsilon<double> * (1 + 1 / h));
        // With the true values instead of the series f‴/6 h² is left, |f‴| ≤ 1.
        CHECK(std::fabs(central_difference(sine, x, h) - slope) <= h * h / 6 + 4 * epsilon<double> * (1 + 1 / h));
    }
}

TEST_CASE("a sine's Taylor series cut after order 1, 3, 5, 7, 9 errs with order 3, 5, 7, 9, 11", "[N09][ch1]") {
    const std::array<double, 10> sine_at_0{0, 1, 0, -1, 0, 1, 0, -1, 0, 1};
    for (const int n : {1, 3, 5, 7, 9}) {
        // The next terms are tⁿ⁺²/(n + 2)! and −tⁿ⁺⁴/(n + 4)!: the local order n + 2 − 2t²/((n +
        // 3)(n + 4)) is right to 0.04 at `high`, to 0.02 on average. At t = 0.25 rounding, 1e-16,
        // is below 2 % of the smallest remainder, 0.25¹¹/11! = 6e-15, and turns the line by less
        // than 0.03.
        const double low = 0.25, high = std::sqrt(0.02 * (n + 3) * (n + 4));
        std::vector<double> steps, errors;
        double factorial = 1;
        for (int k = 2; k <= n + 2; ++k) factorial *= k;
        for (int i = 0; i <= 24; ++i) {
            const double t = low * std::pow(high / low, i / 24.0);
            steps.push_back(t);
            errors.push_back(
                std::fabs(taylor(std::span(sine_at_0).first(static_cast<std::size_t>(n) + 1), t) - std::sin(t)));
            // The series alternates: what is cut off is less than its first term.
            CHECK(errors.back() <= std::pow(t, n + 2) / factorial + 2 * epsilon<double>);
        }
        CHECK_THAT(measured_order(steps, errors), WithinAbs(n + 2, 0.05));
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
