// The whole-body methods: what they keep, the way back, exact cases, and the edges.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <timestep/gyroscopic.hpp>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/strang.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>
#include <timestep/rigid/tumble.hpp>

#include "random_inertia.hpp"
#include "spins.hpp"

using namespace timestep;
using V = Vector3<double>;
using Spin = SpinState<double>;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

template <class Visit>
void for_each_tumbler(const Visit& visit) {
    std::apply(
        [&](const auto&... method) { (visit(method), ...); },
        std::tuple{tumble<ImplicitGyroscopic>, tumble<PassiveGyroscopic>, tumble<HalfStepJacobian>,
                   tumble<CalmHalfStep>, tumble<CayleyGyroscopic>, strang, ball_and_remainder_2, ball_and_remainder_4});
}
template <class Visit>
void for_each_splitting(const Visit& visit) {
    visit(strang), visit(ball_and_remainder_2), visit(ball_and_remainder_4);
}

}  // namespace

TEST_CASE("the solvers solve the equations that they say", "[library][ch8]") {
    RandomInertia random(11);
    for (int i = 0; i < 300; ++i) {
        const auto I = random.inertia<double>(100);
        const V w = random.direction<double>();
        const double h = 0.4;
        // Kahan: x₁y₂ + x₂y₁ for every 2xy. Its solve may lose as many digits as the ratio has.
        const V k = half_step_jacobian.step(I, w, h);
        const V mixed = w.cross(I.momentum(k)) + k.cross(I.momentum(w));
        CHECK((I.momentum(k - w) + h / 2 * mixed).norm() < 200 * 64 * epsilon * I.momentum(w).norm());
        const V c = cayley_gyroscopic.step(I, w, h);
        const V L = I.momentum(w) - h / 2 * w.cross(I.momentum(w));
        CHECK((I.momentum(c - w) - h / 2 * L.cross(w + c)).norm() < 64 * epsilon * I.momentum(w).norm());
    }
}

TEST_CASE("the half-step Jacobian takes a full matrix as its principal axes", "[library][ch8]") {
    RandomInertia random(12);
    for (int i = 0; i < 100; ++i) {
        const auto I = random.inertia<double>(10);
        const Matrix3<double> R = rotation_by(V(3 * random.direction<double>())).toRotationMatrix();
        const Matrix3<double> matrix = R * I.moments.asDiagonal() * R.transpose();
        const FullInertia<double> full((matrix + matrix.transpose()) / 2);
        const V w = random.direction<double>();
        const V expected = R * half_step_jacobian.step(I, w, 0.3);
        CHECK((half_step_jacobian.step(full, V(R * w), 0.3) - expected).norm() < 1e-12);
    }
}

// y turns about t: y + 2(t × y + t × (t × y))/(1 + t·t). The last term is up to 2|y| long. Thirteen roundings make it,
// half an ε each on the worst day: four t·t, two the share, one its product with y, and three each cross product with
// its scale. The energy counts them twice.
TEMPLATE_TEST_CASE("the Cayley step keeps the energy of any body, for every step", "[library][ch8]", float) {
    RandomInertia random(3);
    const double eps = std::numeric_limits<TestType>::epsilon();
    double worst = 0;
    for (double size = 1e-3; size < 2e6; size *= 10)
        for (int i = 0; i < 4000; ++i) {
            const auto I = random.inertia<TestType>(1e6);
            const Vector3<TestType> w = TestType(size) * random.direction<TestType>();
            const auto after = cayley_gyroscopic.step(I, w, TestType(1));
            worst = std::max(worst, std::fabs(energy(I, after) / energy(I, w) - 1));
            if (!after.allFinite()) worst = INFINITY;
        }
    CHECK(worst <= 26 * eps);
}

// Each turn rounds its sine and cosine, and some six products: 2 ε a turn, and 13 turns.
TEMPLATE_TEST_CASE("splittings keep |L| of any body, for every step", "[library][ch8]", float, double) {
    const double eps = std::numeric_limits<TestType>::epsilon();
    for_each_splitting([&](const auto& method) {
        INFO(method.name);
        RandomInertia random(4);
        double worst = 0, longest = 0;
        for (double size = 1e-6; size < 2e6; size *= 10)
            for (int i = 0; i < 1000; ++i) {
                const auto I = random.inertia<TestType>(1e6);
                const Vector3<TestType> w = TestType(size) * random.direction<TestType>();
                const auto s = method.step(I, spinning<TestType>(w), TestType(1));
                worst = std::max(worst, std::fabs(momentum(I, s.omega) / momentum(I, w) - 1));
                longest = std::max(longest, std::fabs(double(s.q.norm()) - 1));
                if (!is_finite(s)) worst = INFINITY;
            }
        CHECK(worst <= 26 * eps);
        CHECK(longest <= 2 * eps);
    });
}

TEST_CASE("the splittings keep the momentum in the world, too", "[library][ch8]") {
    const auto I = box(12.0, 1.0, 2.0, 3.0);
    for_each_splitting([&](const auto& method) {
        Spin s = spinning(V(3, 20, -5));
        const V L = I.momentum(s.omega);
        s = after(method, I, s, 1.0 / 60, 600);  // 600 steps, 26 ε each at the worst
        CHECK((s.q * I.momentum(s.omega) - L).norm() < 600 * 26 * epsilon * L.norm());
    });
}

// (1 − ε²α₃α₁ω₂²)/(1 − ε²α₁α₂ω₃²) with ε = h/2 and α = −ratio; and once round.
TEST_CASE("the half-step Jacobian keeps Kahan's quantities", "[library][ch8]") {
    const auto I = box(12.0, 1.0, 2.0, 3.0);
    const double h = 0.05;
    const auto kept = [&](const V& w, int i) {
        const V alpha = -I.ratio;
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const auto part = [&](int a, int b, int c) { return 1 - h * h / 4 * alpha[a] * alpha[b] * w[c] * w[c]; };
        return part(k, i, j) / part(i, j, k);
    };
    V w(3, 10, -2);
    const V first = w;
    double least = 1, most = 0;
    for (int n = 0; n < 100000; ++n) {
        w = half_step_jacobian.step(I, w, h);
        const double E = kinetic_energy(I, w) / kinetic_energy(I, first);
        least = std::min(least, E), most = std::max(most, E);
    }
    // 1e5 steps, a few ε each, either way.
    for (int i = 0; i < 3; ++i) CHECK(std::fabs(kept(w, i) / kept(first, i) - 1) < 1e-12);
    CHECK(most - least < 0.05);  // the energy swings …
    CHECK(most - least > 1e-4);  // … so there is something that could have drifted
}

TEST_CASE("a step back undoes a step where the page says so", "[library][ch8]") {
    RandomInertia random(6);
    const auto returns = [&](const auto& method, bool yes) {
        INFO(method.name);
        double worst = 0;
        for (int i = 0; i < 100; ++i) {
            const auto I = random.inertia<double>(10);
            const Spin start = spinning(random.direction<double>());
            const Spin back = method.step(I, method.step(I, start, 0.5), -0.5);
            worst = std::max(worst, (back.omega - start.omega).norm() + apart(back.q, start.q));
            CHECK(back.t == start.t);
        }
        CHECK((yes ? worst < 1e-12 : worst > 1e-3));
    };
    returns(tumble<HalfStepJacobian>, true), returns(strang, true);
    returns(ball_and_remainder_2, true), returns(ball_and_remainder_4, true);
    returns(tumble<PassiveGyroscopic>, false), returns(tumble<CayleyGyroscopic>, false);
}

TEMPLATE_TEST_CASE("no whole-body method makes a NaN of finite input", "[library][ch8]", float) {
    using Vec = Vector3<TestType>;
    const PrincipalInertia<TestType> bodies[] = {
        {1, 2, 3},
        {TestType(1.5), TestType(0.5), 1},
        {1, 1, TestType(1e-6)},
        {1, 1, 2},
        {1, TestType(1) + 4 * std::numeric_limits<TestType>::epsilon(), TestType(0.3)},
        {1, 1, 1},
        {TestType(1e-9), TestType(2e-9), TestType(2.5e-9)}};
    const Vec directions[] = {
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {TestType(0.48), TestType(-0.6), TestType(0.64)}};
    for (const auto& I : bodies)
        for (const Vec& d : directions)
            for (double size = 1e-6; size < 2e6; size *= 10)
                for_each_tumbler([&](const auto& method) {
                    INFO(method.name << ", I = " << I.moments.transpose() << ", w = " << size * d.transpose());
                    // The talk's Jacobian may be singular, and half-step's: see the chapter's
                    // tests.
                    if (!is_finite(method.step(I, spinning<TestType>(TestType(size) * d), TestType(1)))) FAIL_CHECK();
                    // Nothing on an axis, and nothing at rest, changes its spin.
                    const int along = int((d.array() != 0).count());
                    const Vec w = TestType(size) * d, now = method.step(I, spinning<TestType>(w), TestType(1)).omega;
                    if (along < 2) CHECK((now - w).norm() <= 8 * std::numeric_limits<TestType>::epsilon() * w.norm());
                });
    for_each_tumbler([&](const auto& method) {  // as small and as large as float has them
        const PrincipalInertia<float> I(1, 2, 2.5f);
        const Vector3<float> d(0.48f, 0.6f, 0.64f);
        CHECK(is_finite(method.step(I, spinning<float>(1e-25f * d), 0.01f)));
        CHECK(method.step(I, spinning<float>(1e-25f * d), 0.01f).omega.isApprox(Vector3<float>(1e-25f * d)));
        CHECK(is_finite(method.step(I, spinning<float>(1e20f * d), 1e-19f)));
        if (method.order > 1 && std::string(method.name) != "half-step Jacobian")
            CHECK(is_finite(method.step(I, spinning<float>(1e9f * d), 1e6f)));
    });
}
