// Three moments at run time pick the kind of inertia, and its formula.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>

#include <timestep/gyroscopic.hpp>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/rigid/any_inertia.hpp>
#include <timestep/rigid/shapes.hpp>

#include "random_inertia.hpp"

using namespace timestep;

namespace {

// The odd axis of a symmetric body, or −1.
template <class Real>
int odd_of(const AnyInertia<Real>& any) {
    const auto& kind = any.kind();
    if (std::holds_alternative<SymmetricAbout<Axis::x, Real>>(kind)) return 0;
    if (std::holds_alternative<SymmetricAbout<Axis::y, Real>>(kind)) return 1;
    return std::holds_alternative<SymmetricInertia<Real>>(kind) ? 2 : -1;
}

}  // namespace

// In so short a step, h|ω| of 4e-5, two rules differ by some hundred (hω)² at most, for this capsule: below 1e-7, a
// hundredth of the change. (That the other two axes are turned as x is, the next case checks.)
TEST_CASE("a symmetric body with its axis along x moves as its full matrix does", "[library]") {
    using V = Vector3<double>;
    const double h = 1e-5;
    const auto pill = about<Axis::x>(capsule(2.0, 0.1, 0.7));
    CHECK(pill.moments().x() == capsule(2.0, 0.1, 0.7).along);
    CHECK(pill.moments().x() < pill.moments().y());
    const FullInertia<double> full(Matrix3<double>(pill.moments().asDiagonal()));
    const V omega(1, -2, 3);
    CHECK((pill.momentum(omega) - full.momentum(omega)).norm() < 1e-15);
    CHECK((pill.velocity(omega) - full.velocity(omega)).norm() < 1e-12);
    const auto same = [&](const auto& solver) {
        INFO(solver.name);
        const V after = solver.step(pill, omega, h);
        CHECK((after - solver.step(full, omega, h)).norm() < 1e-7);
        CHECK((after - omega).norm() > 3e-5);
        CHECK(std::fabs(after.x() - omega.x()) < 1e-7);
    };
    same(explicit_gyroscopic), same(implicit_gyroscopic), same(converged_gyroscopic), same(passive_gyroscopic);
    same(half_step_jacobian), same(calm_half_step), same(cayley_gyroscopic);
}

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
        REQUIRE(odd_of(any) == odd);
        const int i = (odd + 1) % 3, j = (odd + 2) % 3;
        const Vec expected = passive_gyroscopic.step(pill, Vec(w[i], w[j], w[odd]), h);
        const Vec after = any.step(passive_gyroscopic, w, h);
        CHECK(Vec(after[i], after[j], after[odd]) == expected);
        moments[i] *= 1 + 2 * std::numeric_limits<Real>::epsilon();  // as far apart as rounding leaves them
        CHECK(odd_of(AnyInertia<Real>(moments)) == odd);
        moments[i] = Real(1.99);
        CHECK(std::holds_alternative<PrincipalInertia<Real>>(AnyInertia<Real>(moments).kind()));
    }
    RandomInertia random(1);
    for (int n = 0; n < 100; ++n) {
        const auto I = random.inertia<Real>(100);
        CHECK(AnyInertia<Real>(I.moments).step(calm_half_step, w, h) == calm_half_step.step(I, w, h));
    }
}
