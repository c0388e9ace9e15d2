// The models' derivatives against those of calculus, their exact solutions, and what they refuse.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Core>

#include <timestep/methods/implicit_euler.hpp>
#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/tether.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

#include "dual.hpp"

using namespace timestep;
using test_support::Dual;
using Vector3 = Eigen::Vector3d;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// The matrix of derivatives of a vector function, column by column.
template <class Function>
Eigen::Matrix3d derivative(const Function& f, const Vector3& at) {
    Eigen::Matrix3d result;
    for (int j = 0; j < 3; ++j) {
        Eigen::Matrix<Dual, 3, 1> x = at.cast<Dual>();
        x(j).slope = 1;
        const Eigen::Matrix<Dual, 3, 1> y = f(x);
        for (int i = 0; i < 3; ++i) result(i, j) = y(i).slope;
    }
    return result;
}

}  // namespace

TEST_CASE("drag brakes against the motion, with the square of the speed", "[library]") {
    const Drag drag(0.25);
    CHECK(drag.acceleration(0.0, 2.0) == -1);
    CHECK(drag.acceleration(0.0, -4.0) == 4);
    CHECK(drag.acceleration(0.0, 0.0) == 0);
    const Vector3 v(2, -1, 2);  // |v| = 3
    CHECK(drag.acceleration(Vector3(0, 0, 0), v) == Vector3(-1.5, 0.75, -1.5));
    // At the terminal speed it holds against gravity.
    const auto shell = Drag<double>::from_terminal_speed(40, 9.81);
    CHECK(std::fabs(shell.acceleration(0.0, -40.0) - 9.81) < 4 * eps * 9.81);

    CHECK_THROWS_AS(Drag(-1.0), std::invalid_argument);
    CHECK_THROWS_AS(Drag(std::nan("")), std::invalid_argument);
    CHECK_THROWS_AS(Drag<double>::from_terminal_speed(0, 9.81), std::invalid_argument);
    CHECK_THROWS_AS(Drag<double>::from_terminal_speed(1e-200, 9.81), std::invalid_argument);
}

TEST_CASE("the slopes of drag are its derivatives", "[library]") {
    const Drag drag(0.25);
    for (const double v : {-3.0, 2.0}) CHECK(drag.slope_v(0.0, v) == -0.5 * std::fabs(v));
    CHECK(drag.slope_v(0.0, 0.0) == 0);
    CHECK(drag.slope_x(0.0, 3.0) == 0);

    const Vector3 x(0, 0, 0), v(2, -1, 2.5);
    const auto brake = [&](const auto& u) { return drag.acceleration(u, u); };
    CHECK((drag.slope_v(x, v) - derivative(brake, v)).norm() < 20 * eps * 3.4);
    CHECK(drag.slope_v(x, Vector3(0, 0, 0)) == Eigen::Matrix3d::Zero());
}

TEMPLATE_TEST_CASE("drag has a slope at every speed, however small", "[library]", float, double, long double) {
    using Real = TestType;
    using Vector = Eigen::Matrix<Real, 2, 1>;
    using Matrix = Eigen::Matrix<Real, 2, 2>;
    const Drag<Real> drag(1);
    for (Real v = 1; v > 0; v /= 2) {  // powers of two: every product is exact
        REQUIRE(drag.slope_v(Real(0), v) == -2 * v);
        REQUIRE(drag.slope_v(Real(0), -v) == -2 * v);
        REQUIRE(is_finite(drag.slope_v(Vector(0, 0), Vector(v, v))));
    }
    // Twice as strong along the motion as across it.
    const Matrix slope = drag.slope_v(Vector(0, 0), Vector(0, 2));
    CHECK(slope == Matrix(Eigen::DiagonalMatrix<Real, 2>(-2, -4)));

    // A swing that dies away comes to rest, through the smallest numbers there are.
    const Scene scene{DampedSpring<Real>(10, 1), Drag<Real>(Real(0.1))};
    const State<Real> end =
        run(implicit_euler, scene, State<Real>{0, 1, 0}, Real(1) / 60, sizeof(Real) > 8 ? 80000 : 6000);
    CHECK(std::fabs(end.x) < std::numeric_limits<Real>::min());
    CHECK(std::fabs(end.v) < std::numeric_limits<Real>::min());
}

TEST_CASE("a tether pulls and pushes along itself", "[library]") {
    const Tether rope(2.0, 5.0);
    CHECK(rope.acceleration(Vector3(3, 4, 0)) == Vector3(0, 0, 0));     // at rest length
    CHECK(rope.acceleration(Vector3(0, 10, 0)) == Vector3(0, -20, 0));  // 5 m too long
    CHECK(rope.acceleration(Vector3(0, 0, 1)) == Vector3(0, 0, 16));    // 4 m too short
    CHECK(rope.acceleration(Vector3(0, 0, 0)) == Vector3(0, 0, 0));     // no direction, no force
    CHECK(rope.energy(State{0, Vector3(0, 10, 0), Vector3(1, 2, 2)}) == 4.5 + 50);

    const auto force = [&](const auto& x) { return rope.acceleration(x); };
    const Vector3 x(2, -1, 2.5);
    CHECK((rope.slope_x(x) - derivative(force, x)).norm() < 20 * eps * 4 * 5);

    // Short tethers push all the same: at |x| = 1e-310 and 1e-170 by L, as their stretch is −L. The
    // direction is right to some ε.
    const Tether rod(1.0, 1.0);
    for (const double r : {1e-100, 1e-170, 1e-300, 1e-310}) {
        CHECK(rod.acceleration(r) == 1);
        CHECK(rod.acceleration(-r) == -1);
        CHECK(rod.slope_x(r) == -1);
        const Vector3 push = rod.acceleration(Vector3(r, -r, 0));
        CHECK((push - Vector3(1, -1, 0) / std::sqrt(2)).norm() < 4 * eps);
    }
    CHECK(rod.acceleration(0.0) == 0);
    CHECK(rod.slope_x(0.0) == -1);
    // Across the tether (1 − L/r) is lost in −1/r; along it the slope is −1.
    for (const double r : {1e-120, 1e-170, 1e-300}) {
        const Eigen::Matrix3d slope = rod.slope_x(Vector3(0, r, 0));
        CHECK(slope(1, 1) == -1);
        CHECK(std::fabs(slope(0, 0) * r - 1) < 4 * eps);
        CHECK((slope(0, 1) == 0 && slope(1, 2) == 0));
    }

    CHECK_THROWS_AS(Tether(-1.0, 1.0), std::invalid_argument);
    CHECK_THROWS_AS(Tether(1.0, -1.0), std::invalid_argument);
    CHECK_THROWS_AS(Tether(1e200, 1.0), std::invalid_argument);
}

// In float: ωt = 3.5 is rounded, and so are the sine and the products with it.
TEST_CASE("a double's spring tells a float's state its future, in float", "[library]") {
    const auto off = [&](const auto& spring) {
        const State<float> rough = spring.exact(State<float>{0, 1, -2}, 0.5f);
        const State<double> fine = spring.exact(State{0, 1.0, -2.0}, 0.5);
        return std::max(std::fabs(rough.x - fine.x), std::fabs(rough.v - fine.v) / 7);
    };
    const float roundoff = 16 * std::numeric_limits<float>::epsilon();
    CHECK(off(Spring(7.0)) < roundoff);
    for (const double zeta : {0.0, 0.1, 1.0, 3.0}) CHECK(off(DampedSpring(7.0, zeta)) < roundoff);
}

TEST_CASE("decay carries its derivative and refuses what is no number", "[library]") {
    const Decay decay(-3.0);
    CHECK(decay(0.0, 2.0) == -6);
    CHECK(decay.slope_y(0.0, 2.0) == -3);
    CHECK_THROWS_AS(Decay(INFINITY), std::invalid_argument);
}

TEST_CASE("a row with free ends drifts, and keeps its momentum", "[library]") {
    using Vector2 = Eigen::Vector2d;
    const CoupledSprings pair(Vector2(1, 3), Vector3(0, 2, 0));
    CHECK(pair.frequencies()(0) == 0);
    const State start{0, Vector2(0.5, 0), Vector2(1, 1)};
    const State<Vector2> s = pair.exact(start, 2.0);
    CHECK(std::fabs((s.v(0) + 3 * s.v(1)) - 4) < 100 * eps);
    // The middle of mass goes on at 1 m/s.
    CHECK(std::fabs((s.x(0) + 3 * s.x(1)) / 4 - (0.125 + 2)) < 100 * eps);
    // The two against each other: the reduced mass 3/4 on a spring of 2.
    const double omega = std::sqrt(2 / 0.75);
    CHECK(std::fabs((s.x(0) - s.x(1)) - 0.5 * std::cos(omega * 2)) < 100 * eps);

    // Roundoff makes an eigenvalue of zero a little positive or a little negative.
    for (int i = 1; i <= 50; ++i)
        CHECK(CoupledSprings(Vector3(i, 1, 3), Eigen::Vector4d(0, 1.0 / i, 7, 0)).frequencies()(0) == 0);

    // A long drift on stiff springs: with the root of roundoff, 5e-6 1/s, in place of 0 the row
    // would have turned back. Right to some ε of each of the products of two 3 × 3 matrices.
    const CoupledSprings stiff(Vector3(1, 2, 3), Eigen::Vector4d(0, 1e6, 2e6, 0));
    const State<Vector3> far = stiff.exact(State{0, Vector3(0, 0, 0), Vector3(1, 1, 1)}, 1e6);
    for (int i = 0; i < 3; ++i) CHECK(std::fabs(far.x(i) - 1e6) < 1e6 * 100 * eps);

    // Two free pieces drift in two modes; with one wall, or a spring to each, none is free.
    const CoupledSprings apart(Vector3(1, 2, 3), Eigen::Vector4d(0, 5, 0, 0));
    CHECK((apart.frequencies()(1) == 0 && apart.frequencies()(2) > 0));
    CHECK(CoupledSprings(Vector3(1, 2, 3), Eigen::Vector4d(0, 5, 5, 1e-3)).frequencies()(0) > 0);
    CHECK(CoupledSprings(Vector3(1, 2, 3), Eigen::Vector4d(5, 0, 5, 5)).frequencies()(0) > 0);
}

TEST_CASE("coupled springs refuse masses and springs that cannot be", "[library]") {
    using Vector2 = Eigen::Vector2d;
    CHECK_THROWS_AS(CoupledSprings(Vector2(1, 0), Vector3(1, 1, 1)), std::invalid_argument);
    CHECK_THROWS_AS(CoupledSprings(Vector2(1, 1), Vector3(1, -1, 1)), std::invalid_argument);
    CHECK_THROWS_AS(CoupledSprings(Vector2(1, 1), Vector3(1, NAN, 1)), std::invalid_argument);
    CHECK_THROWS_AS(CoupledSprings(Vector2(1e-300, 1), Vector3(1e300, 1, 1)), std::invalid_argument);
    CHECK(CoupledSprings(Vector2(1, 2), Vector3(3, 4, 5)).acceleration(Vector2(1, 10)) ==
          Vector2(-3 + 4 * 9, (-4 * 9 - 5 * 10) / 2.0));
}
