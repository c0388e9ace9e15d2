// A body's step put together from terms. (That sorted bodies move as each does alone, chapter 6's study checks.)
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <cmath>
#include <limits>

#include <timestep/rigid/bodies.hpp>
#include <timestep/rigid/shapes.hpp>

using namespace timestep;
using Catch::Matchers::Message;
using V = Vector3<double>;

namespace {

struct Ball {
    UniformInertia<double> inertia;
    double mass, radius;
};
struct Nothing {};  // a body that has nothing but its motion

BodyState<double> lying(const Ball& ball, const V& v) {
    return {{0, Quaternion<double>::Identity(), V::Zero()}, V(0, 0, ball.radius), v};
}

const Ball ball{sphere(2.0, 0.1), 2, 0.1};

}  // namespace

TEST_CASE("terms of a body's scene refuse numbers that make no sense", "[library][ch6]") {
    CHECK_THROWS_AS(Weight(std::nan("")), std::invalid_argument);
    CHECK_THROWS_MATCHES(Ground(-0.5), std::invalid_argument,
                         Message("friction = -0.5: must be finite and zero or more"));
    CHECK_THROWS_AS(RollingResistance(-0.1), std::invalid_argument);
}

// Sliding, a ball of ⅖ m r² keeps its angular momentum about a point of the plane: it rolls when
// v = 5/7 v₀, whatever the friction. Every impulse changes v by p/m and r ω by 5/2 p/m, so the sum
// v + 2/5 r ω stays to roundoff, and the last step stops the sliding exactly.
TEST_CASE("a sliding ball rolls at five sevenths of its speed", "[library][ch6]") {
    const BodyScene scene{Weight(9.81), Ground(0.3)};
    BodyState<double> m = lying(ball, V(7, 0, 0));
    for (int n = 0; n < 2000; ++n) scene.step(ball, m, 0.001);
    CHECK(std::fabs(m.v.x() - 5) < 1e-11);
    CHECK(std::fabs(ball.radius * m.turning.omega.y() - 5) < 1e-11);
    CHECK(std::fabs(m.x.z() - ball.radius) < 1e-13);  // it neither sinks nor hops
}

// Resistance turns with c r N against ω, friction passes it on: a = c g / (1 + 2/5). So all but
// 0.01 of 1 m/s is gone after 0.99 (7/5)/(c g) s; the step makes it late or early by a few steps at
// the most. In the end resistance stops ω in one step, and friction leaves 5/7 of v: 100 steps
// leave (5/7)^100 < 1e-14.
TEST_CASE("rolling resistance stops a ball, at five sevenths of c g", "[library][ch6]") {
    const double c = 0.05, h = 0.001;
    const BodyScene scene{Weight(9.81), Ground(0.5), RollingResistance(c)};
    BodyState<double> m = lying(ball, V(1, 0, 0));
    m.turning.omega.y() = 1 / ball.radius;
    while (m.v.x() > 0.01 && m.turning.t < 10) scene.step(ball, m, h);
    CHECK(std::fabs(m.turning.t - 0.99 * 1.4 / (c * 9.81)) < 5 * h);
    for (int n = 0; n < 130; ++n) scene.step(ball, m, h);
    CHECK(m.v.norm() < 1e-12);
}

TEST_CASE("a ball in the air neither rubs nor rolls", "[library][ch6]") {
    const BodyScene all{Weight(9.81), Ground(0.5), RollingResistance(0.1)};
    const BodyScene weight_only{Weight(9.81)};
    BodyState<double> a = lying(ball, V(3, 1, 4)), b = a;
    a.turning.omega = b.turning.omega = V(1, 2, 3);
    for (int n = 0; n < 700; ++n) all.step(ball, a, 0.001), weight_only.step(ball, b, 0.001);
    CHECK(a.x == b.x);
    CHECK(a.turning.omega == b.turning.omega);
}

TEST_CASE("a body that no scene could step is refused where it is added", "[library][ch6]") {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    const auto add = [](double mass, double radius, const V& v = V::Zero(), const V& omega = V::Zero()) {
        Bodies<double, Ball> balls;
        BodyState<double> m = lying(ball, v);
        m.turning.omega = omega;
        balls.add(Ball{ball.inertia, mass, radius}, m);
    };
    // 1/1e-320 is no number, 1e-200 has no square, and 1e200 none either.
    for (const double mass : {0.0, -1.0, 1e-320, nan, inf}) CHECK_THROWS_AS(add(mass, 0.1), std::invalid_argument);
    for (const double radius : {0.0, -1.0, 1e-200, 1e200, nan, inf})
        CHECK_THROWS_AS(add(2, radius), std::invalid_argument);
    CHECK_THROWS_MATCHES(add(2, 1e200), std::invalid_argument,
                         Message("radius = 1e+200: must be such that 1/m and r²/I are finite and above zero"));
    for (const double bad : {1e200, nan, inf}) {
        CHECK_THROWS_AS(add(2, 0.1, V(bad, 0, 0)), std::invalid_argument);
        CHECK_THROWS_AS(add(2, 0.1, V::Zero(), V(0, bad, 0)), std::invalid_argument);
    }
    CHECK_NOTHROW(add(2, 0.1, V(1e150, 0, 0), V(0, 1e150, 0)));
    CHECK_NOTHROW(checked(Nothing{}));
}
