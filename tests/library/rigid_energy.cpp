// N51: which gyroscopic step can add energy, over random bodies that could exist.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <timestep/gyroscopic.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>

#include "random_inertia.hpp"
#include "spins.hpp"

using namespace timestep;

namespace {

// In y = √I ω the implicit equation is y₂ + h g∘(y₂y₃, y₃y₁, y₁y₂) = y₁: what is missing, over |y₁|.
template <class Real>
double missing(const PrincipalInertia<Real>& I, const Vector3<Real>& omega1, const Vector3<Real>& omega2, double h) {
    using V = Vector3<double>;
    const V m = I.moments.template cast<double>();
    const double mean = std::cbrt(m.prod());
    const V r = (m / mean).cwiseSqrt();
    const V y1 = r.cwiseProduct(omega1.template cast<double>()), y = r.cwiseProduct(omega2.template cast<double>());
    const V g = V(m.z() - m.y(), m.x() - m.z(), m.y() - m.x()) / mean;
    const V pairs(y.y() * y.z(), y.z() * y.x(), y.x() * y.y());
    return (y - y1 + h * g.cwiseProduct(pairs)).norm() / y1.norm();
}

constexpr double sizes[] = {1e-3, 1e-2, 0.1, 0.3, 1, 2, 10, 100, 1e3, 1e4, 1e5, 1e6};

}  // namespace

TEMPLATE_TEST_CASE("implicit Euler solved to the end never adds energy, and is solved for every body",
                   "[library][N51][N48][long]", float, double) {
    const double epsilon = std::numeric_limits<TestType>::epsilon();
    RandomInertia random(1859);
    double worst = 0, left = 0;
    for (const double size : sizes)
        for (int i = 0; i < 90000; ++i) {
            const auto I = random.inertia<TestType>(1e6);
            const Vector3<TestType> omega = random.direction<TestType>();
            const Vector3<TestType> after = converged_gyroscopic.step(I, omega, TestType(size));
            worst = std::max(worst, energy(I, after) / energy(I, omega));
            left = std::max(left, missing(I, omega, after, size));
        }
    CHECK(worst <= 1 + 8 * epsilon);
    // Each component of y₂ is rounded in its last digit, and with it the products: no more than
    // y₁ + 2 (y₁ + y₂) in size. Ratios and roots are rounded, too: a few dozen ε in all. A wrong root
    // would leave something of the size of y₁.
    CHECK(left < 50 * epsilon);
}

// The rounded orientation is no exact rotation. If every step took the whole of ω into the body and
// back, some boxes would gain several percent of their energy in the hour.
TEST_CASE("in float the passive step of bodies in the world gains nothing in an hour", "[library][N51]") {
    RandomInertia random(1859);
    double rise = 0;
    for (int i = 0; i < 40; ++i) {
        const auto I = random.inertia<float>(10);
        const Vector3<float> start = 5 * random.direction<float>();
        RigidState<float> s{0, Quaternion<float>::Identity(), start};
        double least = 1e9;
        for (int n = 0; n < 216000; ++n) {
            s = step_rotation(passive_gyroscopic, I, s, 1 / 60.0f);
            if (n % 600 != 0) continue;
            const Quaternion<double> q = s.q.cast<double>().normalized();
            const Vector3<float> w = (q.conjugate() * s.omega.cast<double>()).cast<float>();
            const double E = energy(I, w) / energy(I, start);
            least = std::min(least, E), rise = std::max(rise, E / least - 1);
        }
    }
    CHECK(rise < 2e-3);
}

// Four numbers of a turn, rounded, made one that grows or shrinks by the same share in every step: one of
// these hundred bodies had its spin across the axis off by three percent after this hour.
TEST_CASE("in float a symmetric body keeps its energy for an hour", "[library][N51]") {
    RandomInertia random(7);
    double worst = 0;
    for (int i = 0; i < 100; ++i) {
        const SymmetricInertia<float> I(1, 0.02f + 1.9f * float(i) / 100);
        const Vector3<float> start = std::pow(10.0f, float(i % 10) / 4) * random.direction<float>();
        Vector3<float> w = start;
        for (int n = 0; n < 216000; ++n) w = passive_gyroscopic.step(I, w, 1 / 60.0f);
        const auto across = [](const Vector3<float>& v) { return std::hypot(double(v.x()), double(v.y())); };
        worst = std::max(worst, std::fabs(across(w) / across(start) - 1));
        CHECK(w.z() == start.z());
    }
    // Roundoffs that go either way: √216000 of them, of an ε or two each, are 1e-4.
    CHECK(worst < 2e-4);
}

// The rounded cosine of a small angle is one. Used with the sine, it would stretch every turn a little: bodies had up
// to a percent more or less of |L| after this hour.
TEST_CASE("in float a splitting keeps |L| for an hour", "[library][ch8]") {
    RandomInertia random(3);
    double worst = 0;
    for (int i = 0; i < 2; ++i) {
        const auto I = random.inertia<float>(10);
        const RemainderInertia<float> parts(I);
        SpinState<float> s = spinning<float>(10 * random.direction<float>());
        const double before = momentum(I, s.omega);
        for (int n = 0; n < 216000; ++n) s = ball_and_remainder_4.step(parts, s, 1 / 60.0f);
        worst = std::max(worst, std::fabs(momentum(I, s.omega) / before - 1));
    }
    CHECK(worst < 5e-4);  // thirteen turns a step, roundoffs either way: √2.8 million of them are 1e-4
}
