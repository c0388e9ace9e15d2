// The gyroscopic solvers: their equations and their closed forms. (The studies of chapters 5 and 8 measure orders.)
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <timestep/gyroscopic.hpp>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/rigid/shapes.hpp>

#include "random_inertia.hpp"

using namespace timestep;
using V = Vector3<double>;
using M = Matrix3<double>;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

M diagonal(const PrincipalInertia<double>& I) { return I.moments.asDiagonal(); }

}  // namespace

TEST_CASE("the single iteration solves the talk's equations", "[library][N47][N48]") {
    const auto I = box(12.0, 1.0, 2.0, 3.0);
    const V omega(0.1, -0.4, 0.7);
    const double h = 0.5;
    const V L = I.momentum(omega), residual = h * omega.cross(L);
    const M J = diagonal(I) + h * (skew(omega) * diagonal(I) - skew(L));
    const V expected = omega - V(J.partialPivLu().solve(residual));
    CHECK((implicit_gyroscopic.step(I, omega, h) - expected).norm() < 32 * epsilon);
    CHECK((implicit_gyroscopic.step(FullInertia<double>(diagonal(I)), omega, h) - expected).norm() < 32 * epsilon);
    // Where the determinant of J vanishes: I = (3, 2, 1), h|ω| = √3 about the middle axis, nearly.
    const V out = implicit_gyroscopic.step(PrincipalInertia(3.0, 2.0, 1.0), V(1e-6, 1, 1e-6), std::sqrt(3.0));
    CHECK(!(out.norm() < 10));
}

// In steps so short that Newton-Raphson starts all but at the root, and far too many of them.
TEST_CASE("the converged step is the root that is followed from h = 0", "[library][N48]") {
    RandomInertia random(9);
    const PrincipalInertia<double> known(1, 2, 2.5);
    const V middle = 2.372 * V(0.1178, -0.9875, -0.1045);  // where another root is nearer to ω₁
    CHECK(std::fabs(kinetic_energy(known, V(converged_gyroscopic.step(known, middle, 1.0))) /
                        kinetic_energy(known, middle) -
                    0.932) < 0.001);
    for (int i = 0; i < 300; ++i) {
        const auto I = i % 2 ? known : random.inertia<double>(1000);
        const V omega = std::pow(10, -0.3 + 2.3 * (i % 37) / 36) * random.direction<double>();
        V w = omega;
        double farthest = 0;
        for (int n = 1; n <= 2000; ++n) {
            const double h = n * n / 4e6;
            const V before = w;
            for (int k = 0; k < 4; ++k) {
                const V L = I.momentum(w);
                const M J = diagonal(I) + h * (skew(w) * diagonal(I) - skew(L));
                w -= solve3(J, V(I.momentum(w - omega) + h * w.cross(L)));
            }
            farthest = std::max(farthest, (w - before).norm());
        }
        INFO("I = " << I.moments.transpose() << ", omega = " << omega.transpose());
        CHECK(farthest < 0.05 * omega.norm());
        CHECK((converged_gyroscopic.step(I, omega, 1.0) - w).norm() < 1e-6 * omega.norm());
    }
}

TEST_CASE("the passive step solves its equation", "[library][N51]") {
    RandomInertia random(6);
    for (int i = 0; i < 1000; ++i) {
        const auto I = random.inertia<double>(100);
        const V omega = random.direction<double>();
        const double h = std::pow(10, i % 4 - 2);
        const V omega2 = passive_gyroscopic.step(I, omega, h);
        const V L = I.momentum(omega);
        // I (ω₂ − ω₁) = h L × ω₂, over the size of its terms.
        const V rest = I.momentum(omega2 - omega) - h * L.cross(omega2);
        CHECK(rest.norm() < 64 * epsilon * (L.norm() + h * L.norm() * omega2.norm()));
    }
}

TEST_CASE("two equal moments: the closed forms are the general steps", "[library][N48]") {
    RandomInertia random(7);
    const auto pill = capsule(1.0, 0.15, 0.6);
    const PrincipalInertia<double> three(pill.across, pill.across, pill.along);
    for (int i = 0; i < 500; ++i) {
        const V omega = 60 * random.direction<double>();
        const double h = i % 2 ? 1.0 / 60 : 1;
        const V one = implicit_gyroscopic.step(pill, omega, h);
        CHECK((one - implicit_gyroscopic.step(three, omega, h)).norm() < 1e-12 * 60);
        CHECK((one - converged_gyroscopic.step(three, omega, h)).norm() < 1e-12 * 60);
        CHECK((one - converged_gyroscopic.step(pill, omega, h)).norm() == 0);
        // The passive step turns (ω_x, ω_y) by 2 atan(u/(1 − u²/3 + u⁴/9)), u = θ/2.
        const V passive = passive_gyroscopic.step(pill, omega, h);
        const double u = h / 2 * pill.precession_ratio * omega.z(), p = u * u / 3;
        const double angle = 2 * std::atan(u / (1 - p + p * p));
        const V expected(std::cos(angle) * omega.x() - std::sin(angle) * omega.y(),
                         std::sin(angle) * omega.x() + std::cos(angle) * omega.y(), omega.z());
        CHECK((passive - expected).norm() < 1e-13 * 60);
    }
}

TEST_CASE("a full matrix moves as its principal axes do", "[library]") {
    const M R = Quaternion<double>(1, 2, -3, 4).normalized().toRotationMatrix();
    const auto I = box(12.0, 1.0, 2.0, 3.0);
    const M turned = R * diagonal(I) * R.transpose();
    const FullInertia<double> full((turned + turned.transpose()) / 2);
    const V omega(1, 2, 2);
    const auto same = [&](const auto& solver) {
        INFO(solver.name);
        RigidState<double> a{0, Quaternion<double>::Identity(), omega}, b{0, Quaternion<double>(R).conjugate(), omega};
        for (int n = 0; n < 100; ++n) a = step_rotation(solver, I, a, 0.01), b = step_rotation(solver, full, b, 0.01);
        CHECK((a.omega - b.omega).norm() < 1e-12);
    };
    for_each_gyroscopic(same);
    same(half_step_jacobian), same(calm_half_step), same(cayley_gyroscopic);
}

TEST_CASE("balls, and spins about an axis, stay as they are", "[library][N41]") {
    const Quaternion<double> q = Quaternion<double>(1, 2, 3, 4).normalized();
    const auto I = box(12.0, 1.0, 2.0, 3.0);
    for_each_gyroscopic([&](const auto& solver) {
        INFO(solver.name);
        const RigidState<double> ball =
            step_rotation(solver, sphere(1.0, 1.0), RigidState<double>{0, q, {1, 2, 3}}, 0.5);
        if constexpr (requires { solver.step(I, V(), 0.1); }) {
            CHECK(ball.omega == V(1, 2, 3));  // to the last bit: nothing is computed
            for (int i = 0; i < 3; ++i) {
                const V w = 7.0 * V::Unit(i);
                CHECK((solver.step(I, w, 0.5) - w).norm() < 8 * epsilon * 7 * (1 + 40));  // h|ω| of 3.5
            }
            const PrincipalInertia<double> same(2.0, 2.0, 2.0);
            CHECK((solver.step(same, V(1, 2, 3), 0.5) - V(1, 2, 3)).norm() < 32 * epsilon);
        } else {
            CHECK((ball.omega - V(1, 2, 3)).norm() < 32 * epsilon);
        }
    });
}
