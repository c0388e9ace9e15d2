// Three moments at run time pick the kind of inertia, and its formula.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>
#include <stdexcept>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/any_inertia.hpp>

#include "random_inertia.hpp"

using namespace timestep;

TEMPLATE_TEST_CASE("three moments pick a ball, a symmetric body or a box", "[library]", float, double) {
    using Real = TestType;
    using Vec = Vector3<Real>;
    const Vec w(1, -2, 3);
    const Real h = Real(0.1);
    const AnyInertia<Real> ball(Vec(2, 2, 2));
    CHECK(std::holds_alternative<UniformInertia<Real>>(ball.kind()));
    CHECK(ball.step(passive_gyroscopic, w, h) == w);
    const SymmetricInertia<Real> pill(2, Real(0.3));
    for (int odd = 0; odd < 3; ++odd) {
        Vec moments = Vec::Constant(2);
        moments[odd] = Real(0.3);
        const AnyInertia<Real> any(moments);
        REQUIRE(std::holds_alternative<SymmetricInertia<Real>>(any.kind()));
        CHECK(any.odd() == odd);
        const int i = (odd + 1) % 3, j = (odd + 2) % 3;
        const Vec expected = passive_gyroscopic.step(pill, Vec(w[i], w[j], w[odd]), h);
        const Vec after = any.step(passive_gyroscopic, w, h);
        CHECK(Vec(after[i], after[j], after[odd]) == expected);
        moments[i] *= 1 + 2 * std::numeric_limits<Real>::epsilon();  // as far apart as rounding leaves them
        CHECK(AnyInertia<Real>(moments).odd() == odd);
        CHECK(std::holds_alternative<SymmetricInertia<Real>>(AnyInertia<Real>(moments).kind()));
        moments[i] = Real(1.99);
        CHECK(std::holds_alternative<PrincipalInertia<Real>>(AnyInertia<Real>(moments).kind()));
    }
    RandomInertia random(1);
    for (int n = 0; n < 100; ++n) {
        const auto I = random.inertia<Real>(100);
        CHECK(AnyInertia<Real>(I.moments).step(calm_half_step, w, h) == calm_half_step.step(I, w, h));
    }
}

// At the edge of what is a body both must say the same.
TEMPLATE_TEST_CASE("valid() says what the constructor does", "[library]", float, double) {
    using Real = TestType;
    using Limits = std::numeric_limits<Real>;
    const Real eps = Limits::epsilon();
    const auto takes = [](const Vector3<Real>& moments) {
        try {
            AnyInertia<Real> any(moments);
            return true;
        } catch (const std::invalid_argument&) {
            return false;
        }
    };
    int taken = 0, all = 0;
    const Real numbers[] = {0, -1, 1, Real(0.3), 2, 2 * (1 + 4 * eps), 2 * (1 + 20 * eps), 3, Real(1e-6), Limits::min(), Limits::max(), Limits::infinity(), Limits::quiet_NaN()};
    for (const Real a : numbers)
        for (const Real b : numbers)
            for (const Real c : numbers) {
                INFO(a << " " << b << " " << c);
                CHECK(AnyInertia<Real>::valid({a, b, c}) == takes({a, b, c}));
                taken += takes({a, b, c}), ++all;
            }
    CHECK(taken > 50);
    CHECK(taken < all / 2);
}
