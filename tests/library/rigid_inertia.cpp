// Inertia as a type: what it refuses, what shapes it knows, and how orientations turn.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <cmath>
#include <limits>
#include <random>

#include <timestep/lanes.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/solve3.hpp>

#include "random_inertia.hpp"

using namespace timestep;
using Catch::Matchers::Message;
using V = Vector3<double>;
using M = Matrix3<double>;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// The moments of a solid of density one by summing small cells: ∫(y² + z²) and so on.
template <class Inside>
M summed(double reach, int cells, const Inside& inside) {
    M I = M::Zero();
    double mass = 0;
    const double d = 2 * reach / cells;
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j)
            for (int k = 0; k < cells; ++k) {
                const V r(-reach + (i + 0.5) * d, -reach + (j + 0.5) * d, -reach + (k + 0.5) * d);
                if (!inside(r)) continue;
                mass += 1;
                I += r.squaredNorm() * M::Identity() - r * r.transpose();
            }
    return I / mass;
}

}  // namespace

TEST_CASE("an inertia that no body has is refused, with the rule it breaks", "[library][N41]") {
    const auto refused = [](const auto& make, const char* message) {
        CHECK_THROWS_MATCHES(make(), std::invalid_argument, Message(message));
    };
    refused([] { return UniformInertia(0.0); }, "moment of inertia = 0: must be finite and greater than zero");
    refused([] { return PrincipalInertia(1.0, -0.5, 1.0); },
            "moment of inertia = -0.5: must be finite and greater than zero");
    const char* triangle =
        "moment of inertia = 3: must be at most the sum of the other two moments, 2; it exceeds that by 1";
    refused([] { return PrincipalInertia(1.0, 2 + 1e-13, 1.0); },
            "moment of inertia = 2: must be at most the sum of the other two moments, 2; it exceeds that by 9.99e-14");
    refused([] { return PrincipalInertia(1.0, 3.0, 1.0); }, triangle);
    refused([] { return PrincipalInertia(3.0, 1.0, 1.0); }, triangle);
    refused([] { return PrincipalInertia(1.0, 1.0, 3.0); }, triangle);
    refused([] { return SymmetricInertia(1.0, 3.0); }, triangle);
    refused([] { return FullInertia<double>(M(V(1, 3, 1).asDiagonal())); }, triangle);
    refused(
        [] {
            M lopsided = M::Identity();
            lopsided(0, 1) = 0.25;
            return FullInertia<double>(lopsided);
        },
        "inertia's asymmetry = 0.25: must be zero: the matrix equals its transpose");
    refused(
        [] {
            M hole = M::Identity();
            hole(2, 2) = NAN;
            return FullInertia<double>(hole);
        },
        "inertia = nan: must be a finite number");
    refused([] { return box(1.0, 1.0, 0.0, 1.0); }, "side = 0: must be finite and greater than zero");
    refused([] { return capsule(-1.0, 1.0, 1.0); }, "mass = -1: must be finite and greater than zero");
}

TEST_CASE("an exact plate is a body, and one that is thinner than nothing is not", "[library]") {
    CHECK_NOTHROW(PrincipalInertia(0.1, 0.2, 0.1 + 0.2));
    CHECK_NOTHROW(PrincipalInertia(0.1f, 0.7f, 0.1f + 0.7f));
    CHECK_NOTHROW(SymmetricInertia(0.1, 0.2));
    CHECK_NOTHROW(PrincipalInertia(1.0, 1.0, 2 * (1 + 4 * epsilon)));
    CHECK_THROWS_AS(PrincipalInertia(1.0, 1.0, 2 * (1 + 20 * epsilon)), std::invalid_argument);
}

// An allowance of 8 ε would refuse some plates in ten thousand. What is taken off
// a plate's largest moment is within the 32 ε that its matrix is off by.
TEMPLATE_TEST_CASE("an exact plate is a body in any axes", "[library][long]", float, double) {
    using Real = TestType;
    const Real eps = std::numeric_limits<Real>::epsilon();
    RandomInertia random(16);
    std::mt19937_64 turns(9);
    std::normal_distribution<double> normal;
    const auto in_any_axes = [&](const Vector3<Real>& moments) {
        const Quaternion<double> q(normal(turns), normal(turns), normal(turns), normal(turns));
        const Matrix3<Real> R = q.normalized().cast<Real>().toRotationMatrix();
        const Matrix3<Real> turned = R * moments.asDiagonal() * R.transpose();
        return Matrix3<Real>((turned + turned.transpose()) / 2);
    };
    Real off = 0;
    for (int i = 0; i < 200000; ++i) {
        const Vector3<Real> m = random.template inertia<Real>(100).moments;
        const Real a = m.x(), b = m.y(), largest = a + b;
        const FullInertia<Real> plate(in_any_axes({a, b, largest}));
        const Vector3<Real> found = plate.principal.moments;
        off = std::max(
            off, (found - Vector3<Real>(std::min(a, b), std::max(a, b), largest)).cwiseAbs().maxCoeff() / largest);
    }
    CHECK(off <= 32 * eps);
    // A body that is thinner than nothing by more than that is still refused.
    for (int i = 0; i < 1000; ++i)
        CHECK_THROWS_AS(FullInertia<Real>(in_any_axes({1, 1, 2 * (1 + 64 * eps)})), std::invalid_argument);
}

TEST_CASE("a matrix that cannot know its least moment is refused, in float and in double", "[library]") {
    using F = Eigen::Vector3f;
    CHECK_THROWS_MATCHES(FullInertia<float>(Matrix3<float>(F(1, 1, 1e-6f).asDiagonal())), std::invalid_argument,
                         Message("least moment of inertia = 1e-06: must be 100 roundoffs of the largest or more, or "
                                 "no digit of it is right: give PrincipalInertia its moments, or use double"));
    CHECK_NOTHROW(FullInertia<float>(Matrix3<float>(F(1, 1, 2e-5f).asDiagonal())));
    CHECK_NOTHROW(FullInertia<double>(M(V(1, 1, 1e-6).asDiagonal())));
    CHECK_THROWS_AS(FullInertia<double>(M(V(1, 1, 1e-15).asDiagonal())), std::invalid_argument);
    CHECK_NOTHROW(PrincipalInertia<float>(1, 1, 1e-6f));
}

// Cells on the surface are in or out as a whole. Half a cell of 60 changes a moment by less than 3 %.
TEST_CASE("shapes have the moments of their mass, summed up cell by cell", "[library]") {
    const auto agree = [](double reach, const V& moments, const auto& inside) {
        const M sum = summed(reach, 60, inside);
        CHECK((sum.diagonal() - moments).norm() < 0.03 * moments.norm());
        CHECK((sum - M(sum.diagonal().asDiagonal())).norm() < 1e-9);
    };
    const auto block = [](double a, double b, double c) {
        return [half = V(V(a, b, c) / 2)](const V& r) { return (r.cwiseAbs().array() < half.array()).all(); };
    };
    const auto round = [](const SymmetricInertia<double>& I) { return V(I.across, I.across, I.along); };
    agree(1, V::Constant(sphere(1.0, 1.0).moment), [](const V& r) { return r.norm() < 1; });
    agree(1, V::Constant(cube(1.0, 1.6).moment), block(1.6, 1.6, 1.6));
    agree(1.5, box(1.0, 1.0, 2.0, 3.0).moments, block(1, 2, 3));
    agree(1, round(staff(1.0, 2.0, 0.4)), block(0.4, 0.4, 2));
    agree(1, round(cylinder(1.0, 0.5, 2.0)),
          [](const V& r) { return r.head<2>().norm() < 0.5 && std::fabs(r.z()) < 1; });
    agree(1, round(capsule(1.0, 0.4, 1.2)),
          [](const V& r) { return (r - V(0, 0, std::clamp(r.z(), -0.6, 0.6))).norm() < 0.4; });
    // A rod is the limit of a thin staff.
    CHECK(std::fabs(rod(3.0, 2.0).moment - staff(3.0, 2.0, 1e-6).across) < 1e-11);
}

TEST_CASE("momentum and velocity undo each other", "[library]") {
    const V w(1, -2, 3);
    const auto back = [&](const auto& inertia) { return V(inertia.velocity(inertia.momentum(w)) - w).norm(); };
    M I = V(2, 3, 4).asDiagonal();
    I(0, 1) = I(1, 0) = 0.5;
    CHECK(back(UniformInertia(3.0)) < 8 * epsilon);
    CHECK(back(SymmetricInertia(3.0, 1.0)) < 8 * epsilon);
    CHECK(back(PrincipalInertia(3.0, 2.0, 4.0)) < 8 * epsilon);
    CHECK(back(FullInertia<double>(I)) < 64 * epsilon);
    const RodInertia<double> rod(2.0);
    CHECK(V(rod.velocity(rod.momentum(w))) == V(1, -2, 0));  // nothing about its own axis
}

TEST_CASE("only the ratios of the moments count, and they survive a milligram in float", "[library]") {
    const PrincipalInertia<float> crumb(3e-13f, 4e-13f, 5e-13f), ton(3e9f, 4e9f, 5e9f);
    CHECK((crumb.unit - ton.unit).norm() < 8 * std::numeric_limits<float>::epsilon());
    CHECK((crumb.ratio - ton.ratio).norm() < 8 * std::numeric_limits<float>::epsilon());
    CHECK(std::fabs(crumb.unit.prod() - 1) < 8 * std::numeric_limits<float>::epsilon());
}

// The largest over the least is infinite, or their mean has no digits left.
TEST_CASE("moments that cannot be scaled are refused", "[library]") {
    const auto refused = [](float I1, float I2, float I3, const char* message) {
        CHECK_THROWS_MATCHES(PrincipalInertia<float>(I1, I2, I3), std::invalid_argument, Message(message));
    };
    refused(1e38f, 1e38f, 1e-38f, "moment of inertia = 1e-38: must be so large that the largest over it is finite");
    refused(5e-45f, 4e-45f, 1.4e-45f,
            "moment of inertia = 1.4013e-45: must be such that the moments over their geometric "
            "mean have the product one");
    CHECK_THROWS_AS(PrincipalInertia<double>(1e200, 1e200, 1e-200), std::invalid_argument);
    CHECK_THROWS_AS(PrincipalInertia<double>(5e-324, 5e-324, 5e-324 * 2), std::invalid_argument);
    CHECK_NOTHROW(PrincipalInertia<float>(1, 1, 1e-38f));
    CHECK_NOTHROW(PrincipalInertia<double>(1e300, 1e300, 1e-7));
    // In lanes: any of them.
    using L = Lanes<float>;
    L bad(1);
    bad.set(L::lanes - 1, 1e-45f);
    CHECK_THROWS_AS(PrincipalInertia<L>(L(1), L(1), bad), std::invalid_argument);
    CHECK_NOTHROW(PrincipalInertia<L>(L(1), L(1), L(1e-38f)));
}

TEST_CASE("a full matrix whose inverse is no number is refused", "[library]") {
    const auto even = [](float moment) {
        return FullInertia<float>(Matrix3<float>(moment * Matrix3<float>::Identity()));
    };
    CHECK_THROWS_AS(even(3e-42f), std::invalid_argument);
    CHECK_THROWS_MATCHES(even(2e-39f), std::invalid_argument,
                         Message("least moment of inertia = 2e-39: must be so large that the "
                                 "inverse of the matrix is finite"));
    CHECK(even(4e-39f).inverse.allFinite());
}

TEST_CASE("the orientation turns by nearly h omega, keeps its length and undoes itself", "[library][N42]") {
    const Quaternion<double> q = Quaternion<double>(1, 2, 3, 4).normalized();
    const V omega(0.3, -0.2, 0.6);
    for (const double h : {0.01, 0.1, 1.0, 100.0}) {
        const Quaternion<double> q2 = rotated(q, omega, h);
        CHECK(std::fabs(q2.norm() - 1) < 4 * epsilon);
        const Quaternion<double> step = q2 * q.conjugate();
        const double angle = 2 * std::atan2(step.vec().norm(), std::fabs(step.w()));
        CHECK(std::fabs(angle - 2 * std::atan(h * omega.norm() / 2)) < 16 * epsilon);
        CHECK((rotated(q2, omega, -h).coeffs() - q.coeffs()).norm() < 16 * epsilon);
    }
    CHECK((rotated(q, omega, 0.0).coeffs() - q.coeffs()).norm() < 2 * epsilon);
}

TEST_CASE("a body's momentum and energy do not depend on the axes they are reckoned in", "[library]") {
    const auto brick = box(12.0, 1.0, 2.0, 3.0);
    const Quaternion<double> r = Quaternion<double>(4, -3, 2, 1).normalized();
    const M R = r.toRotationMatrix();
    const M turned_matrix = R * brick.moments.asDiagonal() * R.transpose();
    const FullInertia<double> full((turned_matrix + turned_matrix.transpose()) / 2);
    const RigidState<double> in_principal{0, Quaternion<double>(1, 2, 3, 4).normalized(), {1, 2, 3}};
    const RigidState<double> in_any{0, in_principal.q * r.conjugate(), in_principal.omega};
    CHECK((angular_momentum(brick, in_principal) - angular_momentum(full, in_any)).norm() < 1e-12);
    CHECK(std::fabs(kinetic_energy(brick, in_principal) - kinetic_energy(full, in_any)) < 1e-12);
}

TEST_CASE("a locked axis stays still", "[library]") {
    const LockedAxes<double> upright{{0, 0, 1}};
    CHECK(upright(V(1, 2, 3)) == V(0, 0, 3));
    CHECK(LockedAxes<double>{}(V(1, 2, 3)) == V(1, 2, 3));
}
