// The claims of chapter 2 about the mass-spring-damper, for every damping ratio.

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

#include "dual.hpp"

using namespace timestep;
using test_support::Dual;

namespace {

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

using Wide = long double;
using Matrix = Eigen::Matrix<Wide, 2, 2>;

// The exact solution by another road: e^(At), A the matrix of ẋ = v, v̇ = −ω² x − 2ζω v. The Taylor
// series of e^(At/2ⁿ), squared n times.
State<Wide> by_matrix(Wide omega, Wide zeta, Wide x0, Wide v0, Wide t) {
    Matrix a;
    a << 0, 1, -omega * omega, -2 * zeta * omega;
    int squarings = 0;
    Wide scale = 1;
    for (; (a * t * scale).cwiseAbs().sum() > 0.5L; scale /= 2) ++squarings;
    const Matrix small = a * (t * scale);
    Matrix sum = Matrix::Identity(), term = Matrix::Identity();
    for (int i = 1; i < 25; ++i) {
        term = term * small / i;
        sum += term;
    }
    for (int i = 0; i < squarings; ++i) sum = Matrix(sum * sum);
    const Eigen::Matrix<Wide, 2, 1> y = sum * Eigen::Matrix<Wide, 2, 1>(x0, v0);
    return {t, y(0), y(1)};
}

int crossings(const DampedSpring<double>& legs, const State<double>& start, double seconds, int samples) {
    int count = 0;
    double before = start.x;
    for (int i = 1; i <= samples; ++i) {
        const double x = legs.exact(start, seconds * i / samples).x;
        if (x == 0) continue;
        if ((x < 0) != (before < 0)) ++count;
        before = x;
    }
    return count;
}

}  // namespace

TEST_CASE("the damped solution solves the equation, for zeta below, at and above 1", "[N17][ch2]") {
    const double zeta = GENERATE(0.0, 0.1, 0.9, 1 - 1e-8, 1 - 1e-16, 1.0, 1 + 3e-16, 1 + 1e-8, 1.1, 3.0, 1e4);
    const double omega = GENERATE(0.01, 1.0, 8.0, 300.0);
    const double wt = GENERATE(0.0, 0.1, 1.0, 5.0, 30.0);
    const double x0 = GENERATE(0.0, 0.25), v0 = GENERATE(-2.0, 0.0, 1.0);
    const DampedSpring legs(omega, zeta);
    const State<Dual> s = legs.exact(State<Dual>{0, x0, v0}, Dual(wt / omega, 1));
    CAPTURE(zeta, omega, wt, x0, v0);

    // Both sides of an equation are sums of the same few exponentials, each times a product or two
    // with x₀ or v₀, rounded some 20 times in all. (The exponent qt rounds by ε qt, but where that
    // is much, e^(−qt) is small: qt e^(−qt) < 0.4.) The damping's 2ζω v is the largest term of all.
    const double speed = std::fabs(v0) + omega * std::fabs(x0);
    const double force = omega * (1 + 2 * zeta) * speed;
    CHECK(std::fabs(s.x.slope - s.v.value) <= 20 * eps<double> * speed);
    CHECK(std::fabs(s.v.slope - acceleration(legs, s.x.value, s.v.value)) <= 20 * eps<double> * force);

    const State at_start = legs.exact(State{0, x0, v0}, 0.0);
    CHECK(at_start.x == x0);
    CHECK(at_start.v == v0);
}

TEST_CASE("near zeta = 1 no digits are lost, from either side", "[N17][ch2]") {
    if (eps<Wide> == eps<double>) SKIP("long double is no wider than double here");
    const double exponent = GENERATE(-1, -2, -3, -5, -7, -9, -11, -13, -15);
    const double side = GENERATE(-1.0, 0.0, 1.0);
    const double wt = GENERATE(0.01, 0.5, 1.0, 2.0, 4.0, 8.0);
    const double zeta = 1 + side * std::pow(10.0, exponent);
    const double omega = 8, x0 = 0.25, t = wt / omega;
    const double v0 = GENERATE(0.0, -3.0);
    CAPTURE(zeta, wt, v0);

    const State<double> s = DampedSpring(omega, zeta).exact(State{0, x0, v0}, t);
    const State<Wide> exact = by_matrix(omega, zeta, x0, v0, t);
    // All terms are below e^(−pt) (1 + 2ωt) (x₀ + |v₀|/ω); sqrt, product and sum round the exponent
    // pt by 3ε pt, and a term is rounded some 10 times.
    const double p = zeta < 1 ? omega * zeta : omega * (zeta - std::sqrt(zeta * zeta - 1));
    const double scale = std::exp(-p * t) * (1 + 2 * wt) * (x0 + std::fabs(v0) / omega);
    const double tolerance = (10 + 3 * wt) * eps<double> * scale;
    CHECK(std::fabs(s.x - static_cast<double>(exact.x)) <= tolerance);
    CHECK(std::fabs(s.v - static_cast<double>(exact.v)) <= tolerance * omega);
}

TEMPLATE_TEST_CASE("the three formulas meet at zeta = 1", "[N17][ch2]", float, double, long double) {
    const TestType omega = 2, t = TestType(1.5);
    const State<TestType> start{0, 1, TestType(0.5)};
    const auto x = [&](TestType zeta) { return DampedSpring(omega, zeta).exact(start, t).x; };
    // x = (x₀ + (v₀ + ω x₀) t) e^(−ωt) at ζ = 1.
    const TestType critical = (1 + TestType(2.5) * t) * std::exp(-omega * t);
    CHECK(std::fabs(x(1) - critical) <= 8 * eps<TestType> * critical);
    // The neighbours: dx/dζ is below 2 here, and ζ moves by ε.
    CHECK(std::fabs(x(std::nextafter(TestType(1), TestType(0))) - critical) <= 10 * eps<TestType> * critical);
    CHECK(std::fabs(x(std::nextafter(TestType(1), TestType(2))) - critical) <= 12 * eps<TestType> * critical);
}

TEST_CASE("strong damping and long times neither overflow nor cancel", "[N17][ch2]") {
    const double zeta = GENERATE(1.0, 10.0, 1e4, 1e8, 1e200);
    const DampedSpring legs(1.0, zeta);
    const State start{0, 1.0, 0.0};

    // For large ζ the slow rate is p = ω/(2ζ) (1 + 1/(4ζ²) + …): exact in double from 1e8 on.
    if (zeta >= 1e8) {
        const State s = legs.exact(start, zeta);
        CHECK(std::fabs(s.x - std::exp(-0.5)) <= 4 * eps<double>);
        CHECK(std::fabs(s.v * 2 * zeta + std::exp(-0.5)) <= 8 * eps<double>);
    }
    // When the fast exponential is gone, every start moves along v = −p x, to the last digits.
    if (zeta >= 10) {
        const double p = 1 / (zeta + std::sqrt(zeta - 1) * std::sqrt(zeta + 1));
        for (const double v0 : {0.0, -0.5, 4.0}) {
            const State s = legs.exact(State{0, 1.0, v0}, 100 / zeta + 1 / p);
            CHECK(std::fabs(s.v / (-p * s.x) - 1) <= 20 * eps<double>);
        }
    }
    for (const double t : {1e3, 1e10, 1e100, 1e300}) {
        const State s = legs.exact(start, t);
        CHECK(is_finite(s));
        CHECK((s.x >= 0 && s.x <= 1));
        CHECK(s.v <= 0);
    }
    const State gone = DampedSpring(1.0, 1.0).exact(start, 1e6);
    CHECK(gone.x == 0);
}

TEST_CASE("without damping it is the spring, without a spring it drifts", "[N17][ch2]") {
    const State start{0, 0.5, -1.0};
    const State damped = DampedSpring(3.0, 0.0).exact(start, 2.0), plain = Spring(3.0).exact(start, 2.0);
    CHECK(std::fabs(damped.x - plain.x) <= 4 * eps<double>);
    CHECK(std::fabs(damped.v - plain.v) <= 12 * eps<double>);
    for (const double zeta : {0.0, 1.0, 5.0}) {
        const State drifting = DampedSpring(0.0, zeta).exact(start, 2.0);
        CHECK(drifting.x == -1.5);
        CHECK(drifting.v == -1);
    }
}

TEST_CASE("m, k and c become omega and zeta", "[N17][ch2]") {
    const auto legs = DampedSpring<double>::from_stiffness(5120, 128, 80);
    CHECK(std::fabs(legs.omega - 8) <= 2 * eps<double> * 8);
    CHECK(std::fabs(legs.zeta - 0.1) <= 4 * eps<double> * 0.1);
    // m ẍ = −k x − c v
    CHECK(std::fabs(80 * legs.acceleration(0.3, -2.0) - (-5120 * 0.3 + 128 * 2.0)) <= 10 * eps<double> * 1536);
    // Critical damping is c = 2√(k m).
    CHECK(std::fabs(DampedSpring<double>::from_stiffness(5120, 1280, 80).zeta - 1) <= 2 * eps<double>);
    CHECK_THROWS_AS(DampedSpring<double>::from_stiffness(0, 1, 1), std::invalid_argument);
    CHECK_THROWS_AS(DampedSpring<double>::from_stiffness(1, -1, 1), std::invalid_argument);
    CHECK_THROWS_AS(DampedSpring<double>::from_stiffness(1, 1, 0), std::invalid_argument);
}

TEST_CASE("let go at rest, it swings for zeta < 1 and only creeps back from 1 on", "[N17][ch2]") {
    const State start{0, 1.0, 0.0};
    for (const double zeta : {0.0, 0.3, 0.7, 0.9}) {
        // A half swing takes π / (ω √(1 − ζ²)).
        const double half_swing = 3.15 / std::sqrt(1 - zeta * zeta);
        CHECK(crossings(DampedSpring(1.0, zeta), start, half_swing, 1000) == 1);
    }
    for (const double zeta : {1.0, 1.0001, 2.0, 30.0}) {
        const DampedSpring legs(1.0, zeta);
        double before = 1;
        for (int i = 1; i <= 1000; ++i) {
            const double x = legs.exact(start, 0.05 * i).x;
            CHECK((0 < x && x < before));
            before = x;
        }
    }
}

TEST_CASE("erratum: beyond zeta = 1 it crosses zero once if thrown fast enough", "[N17][ch2]") {
    const double zeta = GENERATE(1.0, 1.2, 3.0);
    const double root = std::sqrt(zeta * zeta - 1), p = zeta - root, q = zeta + root;
    const DampedSpring legs(1.0, zeta);
    for (const double factor : {-3.0, 0.0, 0.5, 0.99}) {
        CHECK(crossings(legs, State{0, 1.0, -factor * q}, 40, 4000) == 0);
    }
    for (const double factor : {1.5, 2.0, 10.0}) {
        const State start{0, 1.0, -factor * q};
        CHECK(crossings(legs, start, 40, 4000) == 1);
        // x = 0 where e^((q − p)t) = (v₀ + p)/(v₀ + q); at ζ = 1 that tends to t = −1/(v₀ + 1).
        const double when = zeta == 1 ? -1 / (start.v + 1) : std::log((start.v + p) / (start.v + q)) / (q - p);
        CHECK(std::fabs(legs.exact(start, when).x) <= 20 * eps<double> * factor);
    }
}

TEST_CASE("the portrait of a damped oscillation spirals inwards, clockwise", "[N17][ch2]") {
    const DampedSpring legs(8.0, 0.1);
    const State start{0, 0.25, 0.0};
    const double turn = 2 * 3.14159265358979 / (8 * std::sqrt(1 - 0.01));
    State before = start;
    for (int i = 1; i <= 400; ++i) {
        const State s = legs.exact(start, turn * i / 100);
        CHECK(before.x * s.v - s.x * before.v < 0);  // clockwise
        before = s;
    }
    // Each turn shrinks it by e^(−ζω · turn).
    const State once = legs.exact(start, turn), twice = legs.exact(start, 2 * turn);
    const double shrinks = std::exp(-0.8 * turn);
    CHECK(std::fabs(once.x / 0.25 - shrinks) < 1e-14);
    CHECK(std::fabs(twice.x / once.x - shrinks) < 1e-14);
}

TEST_CASE("RK4 in small steps finds the damped solution, too", "[N17][ch2]") {
    const double zeta = GENERATE(0.1, 1.0, 1.2);
    const DampedSpring legs(2.0, zeta);
    const State start{0, 0.25, -1.0};
    const State exact = legs.exact(start, 1.0), stepped = run(runge_kutta_4, legs, start, 1.0 / 256, 256);
    // The rates are below q = 2 · 1.86: (qh)⁵/120 a step, 256 steps, of an amplitude below 1.
    CHECK(std::fabs(stepped.x - exact.x) < 256 * std::pow(3.8 / 256, 5) / 120);
}
