// The exact free body: elliptic functions, and the motion against an independent integration.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <timestep/rigid/shapes.hpp>

#include "exact_free_body.hpp"
#include "extrapolation.hpp"
#include "random_inertia.hpp"

template class timestep::ExactFreeBody<float>;
template class timestep::ExactFreeBody<double>;

using namespace timestep;
using V = Vector3<double>;
using Long = long double;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
const Quaternion<double> identity = Quaternion<double>::Identity();

// The independent reference: orientation and spin in long double, by extrapolation.
using Y = Eigen::Matrix<Long, 7, 1>;  // q as x, y, z, w, then ω in the body
Y start_of(const V& omega) { return (Y() << identity.coeffs().cast<Long>(), omega.cast<Long>()).finished(); }
auto rate_of(const PrincipalInertia<double>& inertia) {
    return [I = Vector3<Long>(inertia.moments.cast<Long>())](Long, const Y& y) -> Y {
        const Vector3<Long> omega = y.tail<3>(), L = I.cwiseProduct(omega);
        const Quaternion<Long> at(y[3], y[0], y[1], y[2]), spin(0, omega.x() / 2, omega.y() / 2, omega.z() / 2);
        return (Y() << (at * spin).coeffs(), L.cross(omega).cwiseQuotient(I)).finished();
    };
}

struct Off {
    double spin, orientation;
};

// How far the formulas are off the reference, at worst over `seconds`.
Off against_reference(const PrincipalInertia<double>& I, const V& omega, double seconds) {
    const ExactFreeBody<double> exact(I, {0, identity, omega});
    const auto rate = rate_of(I);
    Y y = start_of(omega);
    Off worst{0, 0};
    const int checks = 40;
    for (int n = 1; n <= checks; ++n) {
        y = test_support::extrapolated(rate, y, Long(0), Long(seconds) / checks, 1);
        const auto s = exact(seconds * n / checks);
        const V w = s.q.conjugate() * s.omega;
        const auto a = s.q.coeffs().cast<Long>().eval(), b = y.head<4>().eval();
        worst.spin = std::max(worst.spin, double((w.cast<Long>() - y.tail<3>()).norm() / y.tail<3>().norm()));
        worst.orientation = std::max(worst.orientation, double(std::min((a - b).norm(), (a + b).norm())));
    }
    return worst;
}

}  // namespace

TEST_CASE("sn, cn and dn: their identities, their limits and their derivatives", "[library][N40]") {
    for (const double m1 : {1.0, 0.7, 0.1, 1e-3, 1e-8, 1e-15, 1e-300, 0.0})
        for (double u = -12; u <= 12; u += 0.37) {
            const auto f = jacobi(u, m1);
            CHECK(std::fabs(f.sn * f.sn + f.cn * f.cn - 1) < 8 * epsilon);
            CHECK(std::fabs(f.dn * f.dn + (1 - m1) * f.sn * f.sn - 1) < 8 * epsilon);
            // A central difference of step d is off by d²/6 times a third derivative of at most 5.
            const double d = 1e-5;
            const auto after = jacobi(u + d, m1), before = jacobi(u - d, m1);
            CHECK(std::fabs((after.sn - before.sn) / (2 * d) - f.cn * f.dn) < 1e-10 + 64 * epsilon / d);
        }
    CHECK(std::fabs(jacobi(0.5, 1.0).sn - std::sin(0.5)) < 4 * epsilon);
    CHECK(std::fabs(jacobi(2.0, 0.0).cn - 1 / std::cosh(2.0)) < 4 * epsilon);
    CHECK(std::fabs(jacobi(1e-300, 0.5).sn - 1e-300) < 1e-315);
}

// Every order of the axes, and spins near each of them; a second integration that shares nothing
// with the formulas.
TEST_CASE("the exact motion agrees with an independent integration to 1e-11", "[library][N40][N42]") {
    const double moments[3] = {1, 2, 2.8};
    int order[3] = {0, 1, 2};
    do {
        const PrincipalInertia<double> I(moments[order[0]], moments[order[1]], moments[order[2]]);
        for (const V& omega :
             {V(1, 0.6, -0.4), V(-0.2, 1, 0.3), V(0.3, -0.2, -1), V(0, 1, 0.5), V(0.5, 0, 1), V(1, -1, 0)}) {
            INFO(I.moments.transpose() << " spun at " << omega.transpose());
            const Off off = against_reference(I, omega, 10);
            CHECK(off.spin < 1e-11);
            CHECK(off.orientation < 1e-11);
        }
    } while (std::next_permutation(order, order + 3));
}

TEST_CASE("two or three equal moments, and spins about one axis", "[library][N40]") {
    for (const auto& I : {PrincipalInertia(1.0, 1.0, 1.7), PrincipalInertia(2.0, 1.2, 2.0),
                          PrincipalInertia(0.5, 1.5, 1.5), PrincipalInertia(1.0, 1.0, 1.0)})
        for (const V& omega : {V(1, 0.6, -0.4), V(1, 0, 0), V(0, -1, 0), V(0, 0, 2), V(0, 0, 0), V(0.3, 0, 1)}) {
            INFO(I.moments.transpose() << " spun at " << omega.transpose());
            if (omega.norm() == 0) {
                CHECK(ExactFreeBody<double>(I, {0, identity, omega})(5).q.coeffs() == identity.coeffs());
                continue;
            }
            const Off off = against_reference(I, omega, 6);
            CHECK(off.spin < 1e-11);
            CHECK(off.orientation < 1e-11);
        }
}

// The angle about L takes a third integral times (I₃ − I₁)/I₁: its roundoff, some ε for each radian, times
// the ratio of the moments. The same formulas in long double tell how much: the docstring's 60, and as
// much again for starts that these have not met. Of the digits at the ratio 10, those beyond are lost.
TEST_CASE("the exact orientation loses as many digits as the ratio of the moments has", "[library][N40]") {
    if (std::numeric_limits<Long>::digits == std::numeric_limits<double>::digits) SKIP("long double is double");
    RandomInertia random(43);
    for (const double ratio : {10.0, 1e4, 1e6, 1e8}) {
        double worst = 0;
        for (int i = 0; i < 300; ++i) {
            // A needle: the triangle rule leaves the other two within 1/ratio of each other.
            const double least = 1 / ratio, middle = 1 - least * (0.02 + 0.0032 * i);
            const V omega = random.direction<double>();
            const ExactFreeBody<double> exact({1, middle, least}, {0, identity, omega});
            const ExactFreeBody<Long> truth({1, Long(middle), Long(least)},
                                            {0, Quaternion<Long>::Identity(), omega.cast<Long>()});
            for (const double t : {1.0, 10.0, 100.0}) {
                const auto off = exact(t).q.cast<Long>().conjugate() * truth(Long(t)).q;
                worst = std::max(worst, double(2 * off.vec().norm()) / t);
            }
        }
        INFO("ratio " << ratio << ": " << worst / (epsilon * ratio) << " ε ratio");
        CHECK(worst < 120 * epsilon * ratio);
        CHECK(worst > epsilon * ratio);
    }
}

// On the separatrix 2EI₂ = L² the body turns over once and never again. With I = (1, 2, 3) and equal
// spins about the first and the last axis, I₁(I₂ − I₁)ω₁² = 1 ω₁² and I₃(I₃ − I₂)ω₃² = 3 ω₃², so
// ω₁ = √3 ω₃ is on it. In double √3 is not, by a digit: m₁ is near 1e-16, and its period some 40 radians.
// A motion from there departs from its neighbours by a factor e^(λt), λ = ω₂ √((I₂−I₁)(I₃−I₂)/(I₁I₃)):
// over 4 s of λ = 0.58 by some 10, so 1e-11 still stands.
TEST_CASE("the separatrix is as exact as the rest", "[library][N40]") {
    const PrincipalInertia<double> I(1, 2, 3);
    for (const double side : {1.0, -1.0}) {
        const Off off = against_reference(I, V(std::sqrt(3.0), 0.2 * side, 1), 4);
        CHECK(off.spin < 1e-11);
        CHECK(off.orientation < 1e-11);
    }
    const Off near = against_reference(PrincipalInertia<double>(2, 3, 4), V(std::sqrt(2.0), 0, 1), 4);
    CHECK(near.spin < 1e-11);
    CHECK(near.orientation < 1e-11);
    // I = (3, 4, 6): 3·1 ω₁² = 6·2 ω₃² at ω₁ = 2 ω₃, without rounding: m₁ = 0.
    const ExactFreeBody<double> once(PrincipalInertia<double>(3, 4, 6), {0, identity, {2, 0.25, 1}});
    const Off off = against_reference(PrincipalInertia<double>(3, 4, 6), V(2, 0.25, 1), 4);
    CHECK(off.spin < 1e-11);
    CHECK(off.orientation < 1e-11);
    // For ever about the middle axis, in the end.
    for (const double t : {100.0, 2000.0, -2000.0}) {
        const V late = once(t).q.conjugate() * once(t).omega;
        CHECK(std::fabs(std::fabs(late.y()) / late.norm() - 1) < 1e-12);
        CHECK(std::fabs(once(t).q.norm() - 1) < 4 * epsilon);
    }
}
