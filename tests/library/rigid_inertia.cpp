// Inertia as a type: what it refuses, what shapes it knows, and how orientations turn.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <cmath>
#include <limits>

#include <timestep/lanes.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/solve3.hpp>

using namespace timestep;
using Catch::Matchers::Message;
using V = Vector3<double>;
using M = Matrix3<double>;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

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

// A cylinder of length 4r/3 and the two halves of a ball have half of the mass each. The centre of half a ball lies
// 3r/8 from its flat side. (The other shapes' moments are in valid_inputs.cpp.)
TEST_CASE("a capsule has the moments of its cylinder and the two halves of its ball", "[library]") {
    const auto pill = capsule(1.0, 1.0, 4.0 / 3);
    CHECK(std::fabs(pill.along - (1 / 2.0 + 2 / 5.0) / 2) < 4 * epsilon);
    CHECK(std::fabs(pill.across - (1 / 4.0 + 4 / 27.0 + 2 / 5.0 + 4 / 9.0 + 1 / 2.0) / 2) < 4 * epsilon);
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
