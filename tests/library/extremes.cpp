// Formulas at the ends of the number range: what can be computed without an overflow on the way,
// is.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Dense>
#include <timestep/game_loop.hpp>
#include <timestep/gyroscopic.hpp>
#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/prothero_robinson.hpp>
#include <timestep/models/tether.hpp>
#include <timestep/models/van_der_pol.hpp>
#include <timestep/run.hpp>
#include <timestep/taylor.hpp>

#include "exact_free_body.hpp"

using namespace timestep;

namespace {

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();
template <class Real>
constexpr Real largest = std::numeric_limits<Real>::max();

}  // namespace

// h⁴ is no number, and its term is zero.
TEST_CASE("a Taylor series takes any step that its terms can take", "[taylor][N09]") {
    const std::array<double, 5> line{1, 2, 0, 0, 0};
    CHECK(taylor(std::span<const double, 5>(line), 1e100) == 2e100);
    const std::array<double, 3> slight{0, 0, 1e-200};
    // ½ h² f″ = ½e100 is, h² is not: three roundings.
    CHECK(std::fabs(taylor(std::span<const double, 3>(slight), 1e150) / 0.5e100 - 1) < 3 * eps<double>);
}

TEMPLATE_TEST_CASE("springs and dampers of any two sizes have their frequency and damping", "[library]", float,
                   double) {
    const TestType big = largest<TestType>, small = 1 / big;
    CHECK(std::isfinite(Spring<TestType>::from_stiffness(small, big).omega));
    CHECK(Spring<TestType>::from_stiffness(small, big).omega > 0);
    // √(k m) = big, and 2√(k m) is no number. c / (2√(k m)) = ½, rounded four times.
    const auto both = DampedSpring<TestType>::from_stiffness(big, big, big);
    CHECK(both.omega == 1);
    CHECK(std::fabs(both.zeta - TestType(0.5)) < 4 * eps<TestType>);
}

// Two frames of 1e308 s are more than a number holds: the second is refused and leaves no trace.
TEST_CASE("a game loop does not owe more than a number", "[I02][library]") {
    GameLoop loop(1e308, 1);
    const auto nothing = [](double) {};
    CHECK(loop.frame(0.9e308, nothing) == 0);
    CHECK_THROWS_AS(loop.frame(1e308, nothing), std::invalid_argument);
    CHECK(loop.alpha() == 0.9);
    CHECK(loop.frame(0.1e308, nothing) == 1);
    CHECK(loop.alpha() < 1);
}

// Between the sines whose square is zero and those whose inverse has a square, dn was ∞/∞.
TEMPLATE_TEST_CASE("elliptic functions of tiny arguments are the argument, 1 and 1", "[library]", float, double) {
    for (TestType u = 1; u > 0; u /= 2) {
        const auto f = jacobi(u, TestType(0.25));
        INFO("u = " << u);
        REQUIRE(std::isfinite(f.sn));
        if (u < std::sqrt(eps<TestType>) / 4) {  // sn = u − (1 + m) u³/6, cn = 1 − u²/2, dn = 1 − m u²/2
            REQUIRE(std::fabs(f.cn - 1) < 4 * eps<TestType>);
            REQUIRE(std::fabs(f.dn - 1) < 4 * eps<TestType>);
            if (u > std::numeric_limits<TestType>::min() / eps<TestType>)
                REQUIRE(std::fabs(f.sn / u - 1) < 8 * eps<TestType>);
        }
    }
}

// The motion of a free body does not know its mass: a power of two leaves the bits as they are.
TEMPLATE_TEST_CASE("a body of any mass has its exact motion", "[library][N40]", float, double) {
    const int far = sizeof(TestType) == 4 ? 120 : 990;
    const RigidState<TestType> start{0, Quaternion<TestType>::Identity(), {1, 2, TestType(-0.5)}};
    const auto at_1 = ExactFreeBody<TestType>(PrincipalInertia<TestType>(1, 2, TestType(2.5)), start)(1);
    for (const int power : {-far, far}) {
        const TestType unit = std::ldexp(TestType(1), power);
        const auto s =
            ExactFreeBody<TestType>(PrincipalInertia<TestType>(unit, 2 * unit, TestType(2.5) * unit), start)(1);
        CHECK(s.omega == at_1.omega);
        CHECK(s.q.coeffs() == at_1.q.coeffs());
    }
}

// In float a body of a milligram has a determinant of 1e-39: too small for its digits.
TEMPLATE_TEST_CASE("the talk's solver turns a full inertia of any mass", "[library][N47]", float, double) {
    const int far = sizeof(TestType) == 4 ? 110 : 990;
    Matrix3<TestType> I;
    I << 2, TestType(0.3), 0, TestType(0.3), TestType(2.5), TestType(0.2), 0, TestType(0.2), 3;
    const Vector3<TestType> omega(1, 2, TestType(-0.5));
    const Vector3<TestType> plain = implicit_gyroscopic.step(FullInertia<TestType>(I), omega, TestType(0.1));
    CHECK((plain - omega).norm() > TestType(0.01));
    for (const int power : {-far, -43, far}) {
        const FullInertia<TestType> scaled(Matrix3<TestType>(std::ldexp(TestType(1), power) * I));
        CHECK(implicit_gyroscopic.step(scaled, omega, TestType(0.1)) == plain);
    }
}

// Newton–Raphson measures sizes whose squares overflow or underflow.
TEMPLATE_TEST_CASE("Newton-Raphson solves for vectors whose squares are no numbers", "[library][N26]", float, double) {
    using V = Eigen::Matrix<TestType, 2, 1>;
    const bool is_float = sizeof(TestType) == 4;
    for (const TestType size :
         {is_float ? TestType(1e-25) : TestType(1e-200), is_float ? TestType(1e20) : TestType(1e200)}) {
        // x + x³/size² = 2 size, component by component: x = size. From there Newton–Raphson halves
        // no step.
        const auto f = [&](const V& x) -> V {
            const V u = x / size;
            return V(u.x() + u.x() * u.x() * u.x() - 2, u.y() + u.y() * u.y() * u.y() - 2) * size;
        };
        const auto slope = [&](const V& x) {
            const V u = x / size;
            return Eigen::Matrix<TestType, 2, 2>(V(1 + 3 * u.x() * u.x(), 1 + 3 * u.y() * u.y()).asDiagonal());
        };
        const V root = newton_raphson(V(3 * size, size / 2), f, slope).x;
        CHECK((root / size - V(1, 1)).norm() < 16 * eps<TestType>);
    }
}

TEST_CASE("a run refuses a step for which the method's own formulas overflow", "[library][N62]") {
    const State<double> start{0, 1, 0};
    CHECK_THROWS_AS(run(velocity_verlet, Projectile(0.0), start, 1e155, 1), std::invalid_argument);
    CHECK_THROWS_AS(run(verlet, Projectile(0.0), start, 1e155, 1), std::invalid_argument);
    CHECK_THROWS_AS(run(constant_acceleration, Projectile(0.0), start, 1e155, 1), std::invalid_argument);
    CHECK_NOTHROW(run(velocity_verlet, Projectile(0.0), start, 1e154, 1));
    CHECK_THROWS_AS(run(implicit_euler, Spring(1e150), start, 1e50, 1), std::invalid_argument);
    CHECK_NOTHROW(run(implicit_euler, Spring(1e150), start, 1.0, 1));
    CHECK_THROWS_AS(run(implicit_euler, DampedSpring(1.0, 1e300), start, 1e10, 1), std::invalid_argument);
    const CoupledSprings light(Eigen::Matrix<double, 1, 1>(1e-300), Eigen::Vector2d(1, 1));
    const State<Eigen::Matrix<double, 1, 1>> pulled{0, Eigen::Matrix<double, 1, 1>(1.0),
                                                    Eigen::Matrix<double, 1, 1>(0.0)};
    CHECK_THROWS_AS(run(implicit_euler, light, pulled, 1e10, 1), std::invalid_argument);
    // h²ω² and 2ζωh are numbers; 1 + both, by which an implicit step divides, is none.
    CHECK_THROWS_AS(run(implicit_euler, DampedSpring(1.1e154, 0.59e154), start, 1.0, 1), std::invalid_argument);
    CHECK_NOTHROW(run(implicit_euler, DampedSpring(1.1e154, 0.1e154), start, 1.0, 1));
    // Of a first-order system h λ.
    const FirstOrder<double> one{0, 1};
    CHECK_THROWS_AS(run(implicit_euler, Decay(-1e300), one, 1e10, 1), std::invalid_argument);
    CHECK_NOTHROW(run(implicit_euler, Decay(-1e300), one, 1e8, 1));
    CHECK_THROWS_AS(run(implicit_midpoint, Decay(-1e300), one, 1e10, 1), std::invalid_argument);
    CHECK_THROWS_AS(run(bdf2, Decay(-1e300), one, 1e10, 1), std::invalid_argument);
    CHECK_THROWS_AS(run(semi_implicit_euler_new_damping, DampedSpring(1.0, 1e300), start, 1e10, 1),
                    std::invalid_argument);
    // √y has a slope everywhere but at its start.
    struct Root {
        double operator()(double, double y) const { return std::sqrt(y); }
        double slope_y(double, double y) const { return 0.5 / std::sqrt(y); }
    };
    CHECK_NOTHROW(run(implicit_euler, Root(), FirstOrder<double>{0, 0}, 0.1, 1));
}

// No explicit method divides by 1 − h ∂a/∂v − h² ∂a/∂x.
TEST_CASE("a run does not refuse a step for a number that its method never uses", "[library]") {
    const State<double> still{0, 0, 0};
    CHECK(run(explicit_euler, Decay(-1e300), FirstOrder<double>{0, 0}, 1e10, 1).y == 0);
    CHECK(run(explicit_euler, Spring(1e150), still, 1e50, 1).x == 0);
    CHECK(run(runge_kutta_4, DampedSpring(1.0, 1e300), still, 1e10, 1).x == 0);
    CHECK(run(semi_implicit_euler_new_damping, Spring(1e150), still, 1e50, 1).x == 0);
}

// Divided by an infinite slope nothing would be left of the force, and the body would fly on.
TEST_CASE("an implicit method does not ignore a force whose slope is no number", "[library][N62]") {
    const State<double> flying{0, 0, 1}, hanging{0, 1, 0};
    const auto reports = [](const auto& method, const auto& model, const auto& start, double h) {
        INFO(method.name);
        CHECK(checked_run(method, model, start, h, 10).blew_up_at > 0);
    };
    const auto both = [&](const auto& method) {
        reports(method, Drag(1.7e308), flying, 1.0 / 64);
        reports(method, Pendulum(1e145), hanging, 1e10);
    };
    both(implicit_euler);
    both(implicit_midpoint);
    both(bdf2);
    CHECK(std::isnan(implicit_euler.step(Decay(-1e300), FirstOrder<double>{0, 1}, 1e10).y));
}

// Newton–Raphson halved an infinite correction for ever.
TEST_CASE("an implicit run of a force or a result too large for a number ends and says so", "[library][N62]") {
    using V = Eigen::Vector2d;
    using Y = FirstOrder<double>;
    const auto blows_up = [](const auto& method, const auto& model, const auto& start, double h) {
        return checked_run(method, model, start, h, 300).blew_up_at;
    };
    const State<V> far{0, V(1e308, 1e308), V(0, 0)}, fast{0, V(0, 0), V(1e200, 1e200)};
    const auto all = [&](const auto& method) {
        INFO(method.name);
        CHECK(blows_up(method, Drag(1.0), State<double>{0, 0, 1e200}, 1.0) == 1);
        CHECK(blows_up(method, Drag(1.0), fast, 1.0) == 1);
        CHECK(blows_up(method, Tether(1e100, 1.0), far, 1.0 / 64) == 1);
        CHECK(blows_up(method, ProtheroRobinson(-1e10), Y{0, 1e300}, 1.0) == 1);
        CHECK(blows_up(method, VanDerPol(1.0), FirstOrder<V>{0, V(1e150, 1e150)}, 1.0) == 1);
    };
    all(implicit_euler);
    all(implicit_midpoint);
    all(bdf2);
    // Each step multiplies by 20, and 20^237 > 1.8e308.
    CHECK(blows_up(implicit_euler, Decay(0.95), Y{0, 1}, 1.0) == 237);
}

TEST_CASE("a checked run says at which step it left the numbers", "[library][N62]") {
    const State<double> start{0, 1, 0};
    // v: −1e200, then −1e200 still as x has not moved; then x = −2e200 and v overflows.
    const auto bad = checked_run(explicit_euler, Spring(1e100), start, 1.0, 1000);
    CHECK(bad.blew_up_at == 3);
    CHECK_FALSE(is_finite(bad.state));
    CHECK(bad.state.t == 1000);
    const auto good = checked_run(implicit_euler, Spring(1e100), start, 1.0, 1000);
    CHECK(good.blew_up_at == std::nullopt);
    CHECK(is_finite(good.state));
    const auto two = checked_run(bdf2, Spring(1.0), State<double>{0, 1e308, 0}, 1.0, 10);  // 4 x₁ overflows
    CHECK(two.blew_up_at == 2);
}

// One look at the end is enough because of this.
TEST_CASE("what is not finite never becomes finite again", "[library][N62]") {
    const double bad[] = {std::nan(""), INFINITY, -INFINITY};
    const auto never = [&](const auto& method) {
        for (const double lost : bad)
            for (const bool in_x : {true, false}) {
                using S = State<double>;
                if (std::is_same_v<std::decay_t<decltype(method)>, Verlet> && !in_x) continue;  // reads no v
                S s = in_x ? S{0, lost, 1} : S{0, 1, lost}, before = s;
                for (int n = 0; n < 10; ++n) {
                    if constexpr (TwoStepMethod<std::decay_t<decltype(method)>, Pendulum<double>, S>) {
                        const S next = method.step(Pendulum(2.0), before, s, 0.1);
                        before = s, s = next;
                    } else {
                        s = method.step(Pendulum(2.0), s, 0.1);
                    }
                    INFO(method.name << ", step " << n);
                    CHECK_FALSE(is_finite(s));
                }
            }
    };
    for_each_method(never);
    for_each_verlet_method(never);
}
