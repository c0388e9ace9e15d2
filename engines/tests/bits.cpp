// The functions for C do what the library's templates do, bit for bit.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <random>

#include "c_functions.hpp"
#include "random_inertia.hpp"

using namespace timestep;

namespace {

// Random bodies and spins, h|ω| from 1e-6 to 1e6: calls look(I, body, ω, q, h).
template <class Real, class Look>
void for_each_throw(unsigned long seed, const Look& look) {
    RandomInertia random(seed);
    std::mt19937 numbers(seed);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 20000; ++i) {
        const auto I = random.inertia<Real>(i % 2 ? 10 : 1000);
        const Real h = i % 5 ? Real(1) / 60 : Real(-1);
        const double angle = std::pow(10, -6 + 12 * (i / 20000.0));
        const Vector3<Real> w = Real(angle / double(std::fabs(h))) * random.direction<Real>();
        Quaternion<Real> q(Real(normal(numbers)), Real(normal(numbers)), Real(normal(numbers)), Real(normal(numbers)));
        q.normalize();
        const Body<Real> body = functions<Real>().from_moments(I.moments.x(), I.moments.y(), I.moments.z());
        INFO("I = " << I.moments.transpose() << ", w = " << w.transpose() << ", h = " << h);
        REQUIRE(body.kind == 2);
        look(I, body, w, q, h);
    }
}

// q v q*/|q|², in double.
template <class Real>
Vector3<Real> turned_over(const Quaternion<Real>& q, const Vector3<Real>& v) {
    const Vector3<double> u = q.vec().template cast<double>(), d = v.template cast<double>();
    const double w = double(q.w());
    const Vector3<double> a = 2 / (u.x() * u.x() + u.y() * u.y() + (u.z() * u.z() + w * w)) * u.cross(d);
    return (d + w * a + u.cross(a)).template cast<Real>();
}

}  // namespace

// As the page In your engine says; some processors of 32 bits pack double closer.
static_assert(sizeof(gyroscopic_bodyf) == 64);
static_assert(sizeof(gyroscopic_body) == 96 || alignof(double) != 8);

extern "C" const Callsf callsf_one_by_one;  // compiled without the vectors of lanes.h

TEST_CASE("in C three numbers one by one have the bits that they have in a vector", "[c]") {
    for_each_throw<float>(1, [&](const auto& I, const auto& three, const Vector3<float>& w, const auto& q, float h) {
        const float across = I.moments.x(), along = std::min(I.moments.y(), 2 * across);
        for (const auto& body :
             {three, functions<float>().from_moments(across, along, across), functions<float>().from_moments(1, 1, 1)})
            for (int i = 0; i < 3; ++i) {
                Vector3<float> lanes = w, single = w;
                functions<float>().rule[i](&body, lanes.data(), h);
                callsf_one_by_one.rule[i](&body, single.data(), h);
                REQUIRE(lanes == single);
                lanes = single = w;
                functions<float>().rule_in_world[i](&body, q.coeffs().data(), lanes.data(), h);
                callsf_one_by_one.rule_in_world[i](&body, q.coeffs().data(), single.data(), h);
                REQUIRE(lanes == single);
            }
    });
}

TEMPLATE_TEST_CASE("in C a rule has the library's bits, in the body and in the world", "[c]", float, double) {
    using Vec = Vector3<TestType>;
    int compared = 0;
    for_each_throw<TestType>(1, [&](const auto& I, const auto& body, const Vec& w, const auto& q, TestType h) {
        for_each_rule([&](int i, const auto& rule) {
            const Vec expected = rule.step(I, w, h);
            Vec after = w;
            functions<TestType>().rule[i](&body, after.data(), h);
            if (functions<TestType>().idle(&body, w.data())) {  // not even rounded
                REQUIRE(after == w);
                return;
            }
            REQUIRE(after.allFinite());
            if (!expected.allFinite()) return;  // a singular half step
            REQUIRE(after == expected);

            const Vec in_world = after_gyroscopic_torque(rule, I, q, w, h);
            Vec turned = w;
            functions<TestType>().rule_in_world[i](&body, q.coeffs().data(), turned.data(), h);
            if (in_world.allFinite()) REQUIRE(turned == in_world);
            ++compared;
        });
    });
    CHECK(compared > 50000);
}

TEMPLATE_TEST_CASE("in C two equal moments have the library's bits, whichever axis is the odd one", "[c]", float,
                   double) {
    using Vec = Vector3<TestType>;
    for_each_throw<TestType>(2, [&](const auto& I, const auto&, const Vec& w, const auto&, TestType h) {
        const TestType across = I.moments.x(), along = std::min(I.moments.y(), 2 * across);
        for (int odd = 0; odd < 3; ++odd) {
            Vec moments = Vec::Constant(across);
            moments[odd] = along;
            const auto body = functions<TestType>().from_moments(moments.x(), moments.y(), moments.z());
            REQUIRE(body.kind == 1);
            REQUIRE(body.odd == odd);
            const int i = (odd + 1) % 3, j = (odd + 2) % 3;
            const SymmetricInertia<TestType> symmetric(across, along);
            for_each_rule([&](int rule, const auto& ours) {
                const Vec expected = ours.step(symmetric, Vec(w[i], w[j], w[odd]), h);
                Vec after = w;
                functions<TestType>().rule[rule](&body, after.data(), h);
                REQUIRE(Vec(after[i], after[j], after[odd]) == expected);
            });
        }
    });
}

TEMPLATE_TEST_CASE("in C what flies has the library's bits", "[c]", float, double) {
    using Vec = Vector3<TestType>;
    const TestType epsilon = std::numeric_limits<TestType>::epsilon();
    for_each_throw<TestType>(3, [&](const auto& I, const auto& body, const Vec& w, const auto& q, TestType h) {
        for (const int four : {0, 1}) {
            const SpinState<TestType> start{0, q, w};
            const auto flown = [&](const SpinState<TestType>& s) {
                return four ? ball_and_remainder_4.step(I, s, h) : ball_and_remainder_2.step(I, s, h);
            };
            const auto expected = flown(start);
            Quaternion<TestType> turned = q;
            Vec after = w;
            functions<TestType>().fly[four](&body, turned.coeffs().data(), after.data(), h);
            if (functions<TestType>().idle(&body, w.data())) {
                REQUIRE(after == w);
                // The angle of a long step is rounded, too: each of its parts some ten times, with the moments' root
                // and A.
                REQUIRE(apart(turned, expected.q) < (16 + 16 * std::fabs(h) * w.norm()) * epsilon);
                continue;
            }
            REQUIRE(after == expected.omega);
            REQUIRE(turned.coeffs() == expected.q.coeffs());

            const SpinState<TestType> in_the_world = flown({0, q, turned_over(Quaternion<TestType>(q.conjugate()), w)});
            Quaternion<TestType> turned2 = q;
            Vec after2 = w;
            functions<TestType>().fly_in_world[four](&body, turned2.coeffs().data(), after2.data(), h);
            REQUIRE(after2 == turned_over(in_the_world.q, in_the_world.omega));
            REQUIRE(turned2.coeffs() == in_the_world.q.coeffs());
        }
    });
}

// The inverse of a rounded inverse is off by a roundoff or two.
TEMPLATE_TEST_CASE("in C a body may be made from one over its moments", "[c]", float, double) {
    const TestType epsilon = std::numeric_limits<TestType>::epsilon();
    RandomInertia random(4);
    for (int n = 0; n < 1000; ++n) {
        const auto I = random.inertia<TestType>(100);
        const auto body =
            functions<TestType>().from_inverse_moments(1 / I.moments.x(), 1 / I.moments.y(), 1 / I.moments.z());
        for (int i = 0; i < 3; ++i) {
            const TestType others = (I.moments.sum() - I.moments[i]) / I.moments[i];
            CHECK(std::fabs(body.unit[i] / I.unit[i] - 1) <= 16 * epsilon);
            CHECK(std::fabs(body.ratio[i] - I.ratio[i]) <= 8 * epsilon * others);
        }
    }
}
