// The splitting into a spherical top and a remainder: what it is exact for, and how a body is divided.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <timestep/rigid/ball_and_remainder.hpp>

#include "exact_free_body.hpp"
#include "random_inertia.hpp"
#include "spins.hpp"

using namespace timestep;
using V = Vector3<double>;
using Spin = SpinState<double>;

static constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Where two moments are equal, wherever they stand: for steps of any length.
TEST_CASE("ball and remainder are exact for a symmetric body", "[library][ch8]") {
    const double needle = 1e-3;
    for (const V& I :
         {V(1, 1, needle), V(1, needle, 1), V(needle, 1, 1), V(1, 1, 2), V(2, 1, 1), V(1, 2, 1), V(1, 1, 1)}) {
        const PrincipalInertia<double> body(I.x(), I.y(), I.z());
        const ExactFreeBody<double> exact(body, in_world(spinning(V(1, 2, -2))));
        for (const double h : {0.1, 1.0, 7.0})
            for (const bool four : {false, true}) {
                const Spin s = four ? after(ball_and_remainder_4, body, spinning(V(1, 2, -2)), h, 10)
                                    : after(ball_and_remainder_2, body, spinning(V(1, 2, -2)), h, 10);
                const Spin truth = in_body(exact(10 * h));
                INFO("I = " << I.transpose() << ", h = " << h);
                // ExactFreeBody: some 60 ε times the ratio for each radian, and 3 rad/s for 10 h.
                CHECK(apart(s.q, truth.q) < 60 * epsilon * 1e3 * 3 * 10 * h + 64 * epsilon);
                CHECK((s.omega - truth.omega).norm() < 60 * epsilon * 1e3 * 3 * 10 * h + 64 * epsilon);
            }
    }
}

TEST_CASE("ball and remainder take a symmetric body as such", "[library][ch8]") {
    const volatile double along = 0.3;  // not known when this is compiled: g++ rounds its own cube root otherwise
    const SymmetricInertia<double> pill(1, along);
    const PrincipalInertia<double> same(1, 1, along);
    const Spin s = spinning(V(1, 2, -2));
    CHECK(ball_and_remainder_2.step(pill, s, 0.1).omega == ball_and_remainder_2.step(same, s, 0.1).omega);
    CHECK(ball_and_remainder_4.step(pill, s, 0.1).omega == ball_and_remainder_4.step(same, s, 0.1).omega);
    CHECK(RemainderInertia<double>(pill).A * RemainderInertia<double>(pill).B == 0);
}

// A small difference of two moments has all its digits: the quotient's rounding, and twice the
// rounding of the scaled moments, some 5 ε each.
TEMPLATE_TEST_CASE("the remainder has all its digits", "[library][ch8]", float, double) {
    using Real = TestType;
    const long double eps = std::numeric_limits<Real>::epsilon();
    const auto exact = [&](const PrincipalInertia<Real>& I) {
        const RemainderInertia<Real> split(I);
        const auto moment = [&](int i) { return static_cast<long double>(I.moments[i]); };
        const long double mean = std::cbrt(moment(0) * moment(1) * moment(2));
        const long double middle = moment(3 - split.a - split.b);
        const auto right = [&](int i, Real remainder) {
            const long double truth = (middle - moment(i)) / moment(i) / middle * mean;
            INFO("I = " << I.moments.transpose() << ", axis " << i);
            CHECK(std::fabs(remainder - truth) <= 16 * eps * std::fabs(truth));
        };
        right(split.a, split.A), right(split.b, split.B);
    };
    const Real one = 1, more = Real(1 + 1e-6), less = Real(0.3);
    exact({one, more, less}), exact({one, less, more}), exact({more, one, less});
    exact({more, less, one}), exact({less, one, more}), exact({less, more, one});
    exact({one, one, less}), exact({one, one, more}), exact({one, one, one});
    RandomInertia random(13);
    for (int i = 0; i < 200; ++i) exact(random.template inertia<Real>(1000));
}
