// The calm half-step: energy and |L| stay, whatever the body, the spin, the steps and the impulses.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/shapes.hpp>

#include "random_inertia.hpp"
#include "spins.hpp"

using namespace timestep;
using V = Vector3<double>;

static constexpr double epsilon = std::numeric_limits<double>::epsilon();

// A few ε a step, more where a division by Δ above 15/16 and moments of 1000:1 make of one rounding
// more: 200 steps of up to 32 substeps, each a few roundings, of which most cancel.
TEST_CASE("the calm half-step keeps energy and |L| of any body at any spin", "[library][ch8]") {
    RandomInertia random(1);
    for (const double size : {0.3, 0.5, 1.0, 2.0, 4.0, 8.0, 30.0, 300.0})
        for (int i = 0; i < 150; ++i) {
            const auto I = random.inertia<double>(1000);
            const V w = size * random.direction<double>();
            INFO("h|ω| = " << size << ", I = " << I.moments.transpose() << ", w = " << w.transpose());
            const double E = energy(I, w), L = momentum(I, w);
            V now = w;
            bool kept = true;
            for (int n = 0; n < 200; ++n) {
                now = calm_half_step.step(I, now, 1.0);
                kept = kept && std::fabs(energy(I, now) / E - 1) < 200 * 8 * epsilon &&
                       std::fabs(momentum(I, now) / L - 1) < 200 * 32 * 8 * epsilon;
            }
            REQUIRE(kept);
        }
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
