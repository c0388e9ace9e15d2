// The claims of chapter 4 about Verlet's positions, its forms, and the constant-force method.

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <timestep/methods.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/stability.hpp>

using namespace timestep;

namespace {

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

// The largest difference of the positions of Verlet and semi-implicit Euler, from the same first
// two.
double apart(double wh, long steps) {
    const Spring spring(1.0);
    State before{0, 1.0, 0.0};
    State semi = semi_implicit_euler.step(spring, before, wh);
    State now = semi;
    double worst = 0;
    for (long n = 1; n <= steps; ++n) {
        worst = std::max(worst, std::fabs(now.x - semi.x));
        semi = semi_implicit_euler.step(spring, semi, wh);
        const State next = verlet.step(spring, before, now, wh);
        before = now;
        now = next;
    }
    return worst;
}

}  // namespace

TEST_CASE("the position equation holds for any velocity that is constant over the step", "[I06][ch4]") {
    // x(t + h) = x + h v is exact where v is constant: linear in v, so that two velocities give the
    // mean of their positions. Fractions of powers of two: no rounding.
    const Projectile still(0.0);
    const double h = 0.125;
    for (const double x : {0.0, 1.0, -3.5})
        for (const double v : {0.0, 2.0, -5.25}) {
            const State end = semi_implicit_euler.step(still, State{0, x, v}, h);
            CHECK(end.x == x + h * v);
            const State other = semi_implicit_euler.step(still, State{0, x, v + 4}, h);
            const State mean = semi_implicit_euler.step(still, State{0, x, v + 2}, h);
            CHECK((end.x + other.x) / 2 == mean.x);
        }
}

TEST_CASE("symplectic Euler moves the position with the velocity of the same step", "[I06][ch4]") {
    const Pendulum pendulum(1.5);
    State before{0, 1.0, 0.3};
    for (int i = 0; i < 100; ++i) {
        const State after = semi_implicit_euler.step(pendulum, before, 0.1);
        CHECK(after.x == before.x + 0.1 * after.v);
        before = after;
    }
}

TEST_CASE("Verlet steps through the positions of semi-implicit Euler", "[I07][ch4]") {
    // Roundoff enters Verlet's x₂ with at most (2 + 3(ωh)²) ε A a step and grows from there like
    // sin nθ / sin θ; that of semi-implicit Euler adds less than as much again. A = 1/√(1 −
    // (ωh)²/4) is the largest |x|.
    for (const double wh : {0.01, 0.1, 1.0, 1.9}) {
        const double theta = std::acos(1 - wh * wh / 2), amplitude = 1 / std::sqrt(1 - wh * wh / 4);
        const double a_step = 2 * (2 + 3 * wh * wh) * eps<double> * amplitude / std::sin(theta);
        CHECK(apart(wh, 100000) < 100000 * a_step);
    }
}

TEST_CASE("one step of Verlet is what hand arithmetic gives", "[I07][ch4]") {
    // ω = 2, h = 1/4, from 1 and 1/2: a = −2, x = 2/2 − 1 − 2/16. No rounding.
    const Spring spring(2.0);
    const State next = verlet.step(spring, State{0, 1.0, 0.0}, State{0.25, 0.5, 0.0}, 0.25);
    CHECK(next.t == 0.5);
    CHECK(next.x == -0.125);
    CHECK(next.v == -0.625 / 0.25 - 0.25);
    // And the first step from x = 1, v = 2: 1 + 1/2 − 4/32.
    CHECK(verlet.start(spring, State{0, 1.0, 2.0}, 0.25).x == 1.375);
}

TEST_CASE("Verlet never looks at the velocity", "[I08][ch4]") {
    const Pendulum pendulum(2.0);
    const State a{0, 0.5, 0.0}, b{0.1, 0.6, 0.0};
    const State wild_a{0, 0.5, 1e9}, wild_b{0.1, 0.6, -std::numeric_limits<double>::quiet_NaN()};
    CHECK(verlet.step(pendulum, a, b, 0.1).x == verlet.step(pendulum, wild_a, wild_b, 0.1).x);
    CHECK(verlet.corrected_step(pendulum, a, b, 0.1, 0.2).x ==
          verlet.corrected_step(pendulum, wild_a, wild_b, 0.1, 0.2).x);
    // A damper does not compile: tests/compile_fail.
    CHECK(PositionForce<Spring<double>, double>);
    CHECK(PositionForce<Projectile<double>, double>);
    CHECK_FALSE(PositionForce<DampedSpring<double>, double>);
}

TEMPLATE_TEST_CASE("the constant-force method is exact on a projectile, for any step", "[I09][ch4]", float, double,
                   long double) {
    const Projectile<TestType> gravity(TestType(-9.81));
    const State<TestType> thrown{0, 2, 14};
    for (const long steps : {1L, 2L, 7L, 100L, 2800L}) {
        const TestType h = TestType(2.8) / steps;
        const State<TestType> end = run(constant_acceleration, gravity, thrown, h, steps);
        const State<TestType> exact = gravity.exact(thrown, h * steps);
        // A step rounds v, 14 or less, and x, 12 or less, by no more than two ε of each; what v
        // lost moves x for the rest of the 2.8 s. h·steps is rounded too, by an ε of 2.8 s at
        // speeds of 14 or less.
        const TestType bound = (TestType(steps) + 2) * 2 * eps<TestType> * (12 + 14 * TestType(2.8));
        CHECK(std::fabs(end.x - exact.x) < bound);
        CHECK(std::fabs(end.v - exact.v) < bound);
    }
}

TEST_CASE("the constant-force method blows up on every undamped spring", "[I09][ch4]") {
    const Spring spring(1.0);
    for (const double wh : {1e-3, 0.1, 1.0, 2.0, 3.0, 3.99}) {
        const double radius = spectral_radius(step_matrix(constant_acceleration, spring, wh));
        // The determinant is 1 + (ωh)²/2, from numbers below 10 that carry an ε each.
        CHECK(std::fabs(radius - std::sqrt(1 + wh * wh / 2)) < 40 * eps<double>);
        CHECK(radius > 1);
    }
    // Past ωh = 4 the pair of roots is real, and the root of the determinant only their geometric
    // mean.
    for (const double wh : {4.5, 6.0, 20.0}) {
        const double radius = spectral_radius(step_matrix(constant_acceleration, spring, wh));
        const double half_trace = 1 - wh * wh / 4, det = 1 + wh * wh / 2;
        CHECK(std::fabs(radius / (std::fabs(half_trace) + std::sqrt(half_trace * half_trace - det)) - 1) < 1e-12);
        CHECK(radius > std::sqrt(det));
    }
}

TEST_CASE("stepping shows the constant-force method's growth", "[I09][ch4]") {
    for (const double wh : {0.1, 0.5, 1.5, 3.0}) {
        const long steps = std::lround(60 / std::log1p(wh * wh / 2));  // to some e³⁰
        const State end = run(constant_acceleration, Spring(1.0), State{0, 1.0, 0.0}, wh, steps);
        const double growth = std::log(std::hypot(end.x, end.v)) / double(steps);
        // In the step's own ellipse every step multiplies by the same; an ellipse of axes q : 1
        // makes at most ln q of the distance. q is that of the matrix (1 − w²/2, w; −w, 1), below 2
        // up to w = 1.5 and below 4 at 3.
        CHECK(std::fabs(growth - std::log1p(wh * wh / 2) / 2) < std::log(4.0) / double(steps));
    }
}

TEST_CASE("plain Verlet, velocity Verlet and leapfrog step through the same positions", "[I10][ch4]") {
    const double h = 0.05;
    const long steps = 2000;
    const State start{0, 1.0, 0.5};
    const Spring spring(1.0);
    std::vector<State<double>> plain, with_velocity, leaping;
    run(verlet, spring, start, h, steps, [&](const auto& s) { plain.push_back(s); });
    run(velocity_verlet, spring, start, h, steps, [&](const auto& s) { with_velocity.push_back(s); });
    run(leapfrog, spring, start, h, steps, [&](const auto& s) { leaping.push_back(s); });
    // As above: a step of plain Verlet rounds by 3 ε A, A = 1.2, which grows by 1/sin θ = 1/h; 2000
    // of them.
    const double bound = 2 * 3 * 1.2 * eps<double> / h * steps;
    for (std::size_t i = 1; i + 1 < plain.size(); ++i) {
        REQUIRE(std::fabs(plain[i].x - with_velocity[i].x) < bound);
        REQUIRE(std::fabs(leaping[i].x - with_velocity[i].x) < bound);
        REQUIRE(std::fabs(leaping[i].v - with_velocity[i].v) < bound);
        const double central = (plain[i + 1].x - plain[i - 1].x) / (2 * h);
        REQUIRE(std::fabs(central - with_velocity[i].v) < bound / h);
    }
}

TEST_CASE("both demos of the talk run with every method", "[I11][ch4]") {
    const Projectile gravity(Eigen::Vector2d(0, -9.81));
    const State<Eigen::Vector2d> thrown{0, {0, 0}, {8, 12}};
    const Eigen::Vector2d lands = gravity.exact(thrown, 2.4).x;
    const auto off = [&](const auto& method) { return (run(method, gravity, thrown, 0.1, 24).x - lands).norm(); };
    // Any Euler misses by h g t/2, and by nothing else: 24 steps round below 1e-12.
    for (const double miss : {off(explicit_euler), off(implicit_euler), off(semi_implicit_euler)})
        CHECK(std::fabs(miss - 0.1 * 9.81 * 2.4 / 2) < 1e-12);
    for_each_verlet_method([&](const auto& method) {
        INFO(method.name);
        CHECK(off(method) < 1e-12);
    });

    const Spring spring(4.0);
    const auto amplitude = [&](const auto& method) {
        const State end = run(method, spring, State{0, 1.0, 0.0}, 0.1, 1000);
        return std::hypot(end.x, end.v / 4);
    };
    // ωh = 0.4. Semi-implicit Euler keeps x² + (v/ω)² − ωh x (v/ω), here 1: on the ellipse's axes,
    // x = ±v/ω, the amplitude is 1/√(1 ∓ ωh/2). The others swing on an upright one within it.
    for (const double stays :
         {amplitude(semi_implicit_euler), amplitude(verlet), amplitude(velocity_verlet), amplitude(leapfrog)}) {
        CHECK(stays > 1 / std::sqrt(1 + 0.2));
        CHECK(stays < 1 / std::sqrt(1 - 0.2));
    }
    CHECK(amplitude(explicit_euler) > 1e30);         // 1.16^500
    CHECK(amplitude(constant_acceleration) > 1e15);  // 1.08^500 = 5e16, give or take the ellipse
    CHECK(amplitude(implicit_euler) < 1e-30);        // 1.16^−500
}

// What exercise 4.2 tells afterwards.
TEST_CASE("put on the floor with \"before\" left alone, a ball stays there", "[ch4]") {
    const Projectile gravity(-9.81);
    const double h = 1.0 / 60;
    for (const double height : {0.3, 1.0, 2.7}) {
        State before{0, height, 0.0}, now = verlet.start(gravity, before, h);
        bool touched = false;
        for (int n = 0; n < 600; ++n) {
            const double last = now.x;
            State next = verlet.step(gravity, before, now, h);
            before = now;
            now = next;
            if (now.x < 0) touched = true, now.x = 0;
            if (touched) CHECK(now.x <= last);
        }
        CHECK(touched);
        CHECK(now.x == 0);
        CHECK(before.x == 0);
    }
}
