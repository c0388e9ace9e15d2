// Gyroscopic steps at the edges of what numbers can hold.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <timestep/gyroscopic.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>

#include "random_inertia.hpp"

using namespace timestep;
using V = Vector3<double>;
using F = Vector3<float>;

TEST_CASE("a needle stays finite, and a rod knows no spin about itself", "[library]") {
    for (const double size : {1e-3, 1.0, 10.0, 1e6})
        CHECK(
            converged_gyroscopic.step(PrincipalInertia(1.0, 1.0, 1e-12), V(V(0.3, -0.8, 0.5) * size), 1.0).allFinite());
    const auto stick = rod(1.0, 2.0);
    RigidState<double> s{0, Quaternion<double>::Identity(), {1, 2, 0}};
    for (int n = 0; n < 1000; ++n) s = step_rotation(passive_gyroscopic, stick, s, 0.01);
    CHECK(s.omega == V(1, 2, 0));
    // A torque along the rod does nothing.
    const RigidState<double> still{0, Quaternion<double>::Identity(), {0, 0, 0}};
    CHECK(step_rotation(passive_gyroscopic, stick, still, V(0, 0, 5), 0.1).omega == V(0, 0, 0));
}

TEST_CASE("a spin of 1e20 or 1e-25 in float is neither lost nor infinite", "[library]") {
    const auto I = box(1.0f, 1.0f, 2.0f, 3.0f);
    const F tiny = 1e-25f * F(1, 2, 2), huge = 1e20f * F(0.1f, 0.2f, 0.2f);
    CHECK(passive_gyroscopic.step(I, tiny, 1 / 60.0f) == tiny);  // hω is nothing: the same bits
    CHECK(converged_gyroscopic.step(I, tiny, 1 / 60.0f).isApprox(tiny));
    const F after = passive_gyroscopic.step(I, huge, 1 / 60.0f);
    CHECK(after.allFinite());
    CHECK(after.norm() > 1e17f);
    const auto pill = capsule(1.0f, 0.15f, 0.6f);
    for (const float size : {1e14f, 1e17f, 1e20f}) {
        const F turned = passive_gyroscopic.step(pill, F(size * F(0.3f, 0.6f, 0.7f)), 1 / 60.0f);
        // In double, as the squares do not fit in float.
        CHECK(std::fabs(turned.cast<double>().norm() / size / V(0.3, 0.6, 0.7).norm() - 1) < 1e-6);
    }
    const V w = huge.cast<double>(), a = after.cast<double>();
    const V moments = I.moments.cast<double>();
    CHECK(a.cwiseAbs2().dot(moments) <= w.cwiseAbs2().dot(moments) * (1 + 8 * 1.2e-7));
}

// Its equations are solved by products of two of their coefficients, which are about hω.
TEST_CASE("the converged solver ends, however large h omega is", "[library][N48]") {
    const PrincipalInertia<float> small(1, 2, 2.5f);
    const PrincipalInertia<double> big(1, 2, 2.5);
    const F f(0.48f, 0.6f, 0.64f);
    const V d(0.48, 0.6, 0.64);
    CHECK(converged_gyroscopic.step(small, F(1e18f * f), 100.0f).hasNaN());
    CHECK(converged_gyroscopic.step(big, V(1e150 * d), 1e6).hasNaN());
    CHECK(converged_gyroscopic.step(big, V(1e200 * d), 100.0).hasNaN());
    // As long as they are, what is left of the spin is about the axis that the exact motion
    // circles: here L² > 2E I₂, so that of the largest moment.
    const F slow = converged_gyroscopic.step(small, F(1e16f * f), 100.0f) / 1e16f;
    CHECK((slow - F(0, 0, 0.64f)).norm() < 1e-6f);
    const V fast = converged_gyroscopic.step(big, V(1e50 * d), 100.0) / 1e50;
    CHECK((fast - V(0, 0, 0.64)).norm() < 1e-15);
}

// What chapter 5 promises: hω up to 1e12 in float and 1e140 in double.
TEMPLATE_TEST_CASE("the passive step of any body is a number and adds no energy up to a vast spin", "[library][N51]",
                   float, double) {
    const bool single = sizeof(TestType) == 4;
    const double limit = single ? 1e12 : 1e140;
    RandomInertia random(3);
    for (int i = 0; i < 3000; ++i) {
        const auto I = random.inertia<TestType>(1e12);
        const Vector3<TestType> way = random.direction<TestType>();
        const TestType h = TestType(std::pow(10, 8 * std::cos(i) - 4)), omega = TestType(limit) / h;
        const Vector3<TestType> before = omega * way, after = passive_gyroscopic.step(I, before, h);
        CAPTURE(I.moments.transpose(), way.transpose(), h);
        REQUIRE(after.allFinite());
        // Over the spin, as squares of it are no numbers.
        const auto energy = [&](const Vector3<TestType>& w) {
            return I.unit.template cast<double>().dot((w.template cast<double>() / double(omega)).cwiseAbs2());
        };
        REQUIRE(energy(after) <= energy(before) * (1 + 64 * std::numeric_limits<TestType>::epsilon()));
    }
}

TEST_CASE("ball and remainder are numbers to 1e19 in float", "[library][ch8]") {
    const RemainderInertia<float> I(PrincipalInertia<float>(1, 2, 2.5f));
    const auto spun = [&](float size) {
        return SpinState<float>{0, Quaternion<float>::Identity(), size * F(0.48f, 0.6f, 0.64f)};
    };
    CHECK(is_finite(ball_and_remainder_2.step(I, spun(1e18f), 1.0f)));
    CHECK(is_finite(ball_and_remainder_4.step(I, spun(1e18f), 1.0f)));
    CHECK(!is_finite(ball_and_remainder_2.step(I, spun(1e20f), 1.0f)));
    CHECK(!is_finite(ball_and_remainder_4.step(I, spun(1e20f), 1.0f)));
}

// Half a turn is what is left of so fast a spin: q₂ = (0, u) q₁, with the axis u.
TEST_CASE("an orientation keeps its length as long as a square does not overflow", "[library][N42]") {
    const Quaternion<float> one = Quaternion<float>::Identity();
    for (const float spin : {1e10f, 1e15f, 1e19f, 1e21f}) {
        const Quaternion<float> q = rotated(one, F(spin * F(2, -1, 2) / 3), 1 / 60.0f);
        INFO("at " << spin << " rad/s");
        CHECK(std::fabs(q.norm() - 1) < 4 * std::numeric_limits<float>::epsilon());
        CHECK((q.vec() - F(2, -1, 2) / 3).norm() < 1e-6f);
    }
    const F beyond(1e22f, 0, 0);
    CHECK(!is_finite(RigidState<float>{0, rotated(one, beyond, 1 / 60.0f), beyond}));
}

TEST_CASE("a quaternion of length zero is no orientation: the state is not finite", "[library][N42]") {
    RigidState<double> s{0, Quaternion<double>(0, 0, 0, 0), {1, 2, 3}};
    CHECK(!is_finite(s));
    s.q.x() = 1e-200;  // short, yet it points somewhere
    CHECK(is_finite(s));
    s.q.x() = std::nan("");
    CHECK(!is_finite(s));
}
