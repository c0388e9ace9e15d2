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

TEST_CASE("no whole-body method makes a NaN of finite input", "[library][ch8]") {
    using Vec = Vector3<float>;
    const PrincipalInertia<float> bodies[] = {{1, 2, 3},
                                              {1.5f, 0.5f, 1},
                                              {1, 1, 1e-6f},
                                              {1, 1, 2},
                                              {1, 1 + 4 * std::numeric_limits<float>::epsilon(), 0.3f},
                                              {1, 1, 1},
                                              {1e-9f, 2e-9f, 2.5e-9f}};
    const Vec directions[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.48f, -0.6f, 0.64f}};
    for (const auto& I : bodies)
        for (const Vec& d : directions)
            for (double size = 1e-6; size < 2e6; size *= 10)
                for_each_tumbler([&](const auto& method) {
                    INFO(method.name << ", I = " << I.moments.transpose() << ", w = " << size * d.transpose());
                    if (!is_finite(method.step(I, spinning<float>(float(size) * d), 1.0f))) FAIL_CHECK();
                    // Nothing on an axis, and nothing at rest, changes its spin.
                    const int along = int((d.array() != 0).count());
                    const Vec w = float(size) * d, now = method.step(I, spinning<float>(w), 1.0f).omega;
                    if (along < 2) CHECK((now - w).norm() <= 8 * std::numeric_limits<float>::epsilon() * w.norm());
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
