// The calm half-step: energy and |L| stay, whatever the body, the spin, the steps and the impulses.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "random_inertia.hpp"
#include "spins.hpp"

using namespace timestep;
using V = Vector3<double>;
using Body = PrincipalInertia<double>;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// How far energy and |L| have ever been off.
struct Off {
    double energy = 0, momentum = 0;
};
template <class Solver, class Real, class Step>
Off off(const Solver& solver, const PrincipalInertia<Real>& I, Vector3<Real> w, long steps, const Step& h) {
    const double E = energy(I, w), L = momentum(I, w);
    Off most;
    for (long n = 0; n < steps; ++n) {
        w = solver.step(I, w, Real(h(n)));
        const double e = std::fabs(energy(I, w) / E - 1), l = std::fabs(momentum(I, w) / L - 1);
        most.energy = e <= most.energy ? most.energy : e;
        most.momentum = l <= most.momentum ? most.momentum : l;
    }
    return most;
}

}  // namespace

// A few ε a step, more where a division by Δ above 15/16 and moments of 1000:1 make of one rounding
// more: 200 steps of up to 32 substeps, each a few roundings, of which most cancel.
TEST_CASE("the calm half-step keeps energy and |L| of any body at any spin", "[library][ch8]") {
    for (const unsigned long seed : {1ul, 20ul, 300ul}) {
        RandomInertia random(seed);
        for (const double size : {0.3, 0.5, 1.0, 2.0, 4.0, 8.0, 30.0, 300.0})
            for (int i = 0; i < 150; ++i) {
                const auto I = random.inertia<double>(1000);
                const V w = size * random.direction<double>();
                INFO("h|ω| = " << size << ", I = " << I.moments.transpose() << ", w = " << w.transpose());
                const Off o = off(calm_half_step, I, w, 200, [](long) { return 1.0; });
                REQUIRE(o.energy < 200 * 8 * epsilon);
                REQUIRE(o.momentum < 200 * 32 * 8 * epsilon);
            }
    }
}

TEST_CASE("the calm half-step has the half-step Jacobian's error for slow spins, and less for fast ones",
          "[library][ch8]") {
    const auto I = box(12.0, 1.0, 2.0, 3.0);
    const auto error = [&](const auto& solver, const V& omega, long steps) {
        const ExactFreeBody<double> exact(I, {0, Quaternion<double>::Identity(), omega});
        const auto end = exact(1);
        V w = omega;
        for (long n = 0; n < steps; ++n) w = solver.step(I, w, 1 / double(steps));
        return (w - end.q.conjugate() * end.omega).norm();
    };
    CHECK(error(calm_half_step, V(1, 2, 2), 60) < 2 * error(half_step_jacobian, V(1, 2, 2), 60));
    // At 60 rad/s and 60 Hz substeps tell the time, and one step does not.
    CHECK(error(calm_half_step, V(20, 40, 40), 60) < error(half_step_jacobian, V(20, 40, 40), 60) / 2);
}

TEMPLATE_TEST_CASE("the calm half-step at the edges of what numbers can hold", "[library][ch8]", float, double) {
    using Vec = Vector3<TestType>;
    const TestType eps = std::numeric_limits<TestType>::epsilon();
    const PrincipalInertia<TestType> I(1, 2, TestType(2.5));
    const Vec d(TestType(0.48), TestType(0.6), TestType(0.64));
    const Vec zero = Vec::Zero();
    CHECK(calm_half_step.step(I, zero, TestType(1)) == zero);
    CHECK(calm_half_step.step(I, d, TestType(0)) == d);  // to the last bit
    CHECK(calm_half_step.step(I, Vec(TestType(1e-25) * d), TestType(0.01)) == Vec(TestType(1e-25) * d));
    for (const double size : {1e3, 1e6, 1e9, 1e15}) {  // far beyond the last substep: too slow, and safe
        const Vec after = calm_half_step.step(I, Vec(TestType(size) * d), TestType(1));
        CHECK(std::fabs(energy(I, after) / energy(I, Vec(TestType(size) * d)) - 1) < 32 * 8 * eps);
        CHECK(std::fabs(momentum(I, after) / momentum(I, Vec(TestType(size) * d)) - 1) < 32 * 8 * eps);
    }
    // (hω)² is no number: nothing moves.
    const TestType huge = std::sqrt(std::numeric_limits<TestType>::max());
    CHECK(calm_half_step.step(I, Vec(huge * d), TestType(1e6)).isApprox(Vec(huge * d)));
    // On an axis, and with all moments equal, ω stays.
    for (int k = 0; k < 3; ++k) {
        const Vec w = TestType(7) * Vec::Unit(k);
        CHECK((calm_half_step.step(I, w, TestType(1)) - w).norm() == 0);
    }
    CHECK((calm_half_step.step(PrincipalInertia<TestType>(2, 2, 2), d, TestType(1)) - d).norm() < 8 * eps);
    // Two equal moments, said and unsaid; and nearly so.
    const SymmetricInertia<TestType> pill(1, TestType(0.3));
    CHECK(calm_half_step.step(pill, d, TestType(0.1)) == passive_gyroscopic.step(pill, d, TestType(0.1)));
    const PrincipalInertia<TestType> same(1, 1, TestType(0.3));
    CHECK((calm_half_step.step(same, d, TestType(0.1)) - calm_half_step.step(pill, d, TestType(0.1))).norm() < 1e-4);
    const PrincipalInertia<TestType> needle(1, 1, TestType(1e-6));
    for (const double size : {1e-3, 1.0, 1e3})
        CHECK(calm_half_step.step(needle, Vec(TestType(size) * d), TestType(1)).allFinite());
}

// Each step rounds some six times, as often up as down: √216000 = 465 of them remain, and the tail.
TEST_CASE("in float the calm half-step keeps energy and |L| for an hour", "[library][ch8]") {
    const PrincipalInertia<float> bodies[] = {
        box(12.0f, 1.0f, 2.0f, 3.0f), box(1.0f, 1.0f, 0.1f, 0.02f), {1, 1.02f, 0.18f}};
    for (const auto& I : bodies)
        for (const float spin : {1.0f, 10.0f, 100.0f}) {
            Vector3<float> w = spin * Vector3<float>(0.6f, 0.64f, 0.48f);
            const double E = energy(I, w), L = momentum(I, w);
            for (int n = 0; n < 216000; ++n) w = calm_half_step.step(I, w, 1 / 60.0f);
            INFO(spin << " rad/s, I = " << I.moments.transpose());
            CHECK(std::fabs(energy(I, w) / E - 1) < 1e-3);
            CHECK(std::fabs(momentum(I, w) / L - 1) < 1e-3);
        }
}

// As engines have it: ω in the world, the orientation turned by the new ω, steps that vary.
TEMPLATE_TEST_CASE("with an orientation, and omega in the world, energy and |L| stay as well", "[library][ch8]", float,
                   double) {
    using Real = TestType;
    // Each step rounds some twenty times, as often up as down.
    const double roundoff = 20 * 190 * double(std::numeric_limits<Real>::epsilon());
    const auto I = box(Real(12), Real(1), Real(2), Real(3));
    for (const Real spin : {Real(10), Real(60)}) {
        RigidState<Real> s{0, Quaternion<Real>::Identity(), spin * Vector3<Real>(Real(0.6), Real(0.64), Real(0.48))};
        const double E = energy(I, s.omega), L = momentum(I, s.omega);
        for (int n = 0; n < 36000; ++n)
            s = step_rotation(calm_half_step, I, s, Real(n % 3 == 0 ? 1.0 / 60 : 1.0 / 120));
        const Vector3<Real> w = s.q.conjugate() * s.omega;
        CHECK(std::fabs(energy(I, w) / E - 1) < roundoff);
        CHECK(std::fabs(momentum(I, w) / L - 1) < roundoff);
    }
}
