// valid() tells an engine whether data that it has read makes a body or a spring; and bodies by their half extents.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <array>
#include <cmath>
#include <limits>

#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/symmetric_about.hpp>

using namespace timestep;

namespace {

// How often `make` succeeded, and how often it refused. valid() must agree each time.
struct Answers {
    int yes = 0, no = 0;
    template <class Make>
    void compare(bool valid, const Make& make) {
        bool made = true;
        try {
            make();
        } catch (const std::invalid_argument&) {
            made = false;
        }
        if (valid != made) FAIL("valid() says " << valid);
        ++(made ? yes : no);
    }
};

template <class Real>
std::array<Real, 15> awkward() {
    using N = std::numeric_limits<Real>;
    return {N::quiet_NaN(), N::infinity(),          -N::infinity(), N::max(),   std::sqrt(N::max()),
            Real(2),        Real(1) + N::epsilon(), Real(1),        Real(1e-6), Real(50) * N::epsilon(),
            N::min(),       N::denorm_min(),        Real(0),        -Real(0),   Real(-1)};
}

}  // namespace

TEMPLATE_TEST_CASE("valid() agrees with the constructor", "[library]", float, double) {
    using Real = TestType;
    Answers spring, damped, symmetric, principal, full, uniform, rods, spheres, cubes, cylinders, capsules, staffs,
        boxes;
    for (const Real a : awkward<Real>()) {
        spring.compare(Spring<Real>::valid(a), [&] { Spring<Real>{a}; });
        uniform.compare(UniformInertia<Real>::valid(a), [&] { UniformInertia<Real>{a}; });
        rods.compare(RodInertia<Real>::valid(a), [&] { RodInertia<Real>{a}; });
        for (const Real b : awkward<Real>()) {
            damped.compare(DampedSpring<Real>::valid(a, b), [&] { DampedSpring<Real>(a, b); });
            symmetric.compare(SymmetricInertia<Real>::valid(a, b), [&] { SymmetricInertia<Real>(a, b); });
            spheres.compare(valid_sphere(a, b), [&] { sphere(a, b); });
            cubes.compare(valid_cube(a, b), [&] { cube(a, b); });
            rods.compare(valid_rod(a, b), [&] { rod(a, b); });
            for (const Real c : awkward<Real>()) {
                cylinders.compare(valid_cylinder(a, b, c), [&] { cylinder(a, b, c); });
                capsules.compare(valid_capsule(a, b, c), [&] { capsule(a, b, c); });
                staffs.compare(valid_staff(a, b, c), [&] { staff(a, b, c); });
                for (const Real d : {Real(0), Real(1), std::sqrt(std::numeric_limits<Real>::max())})
                    boxes.compare(valid_box(a, b, c, d), [&] { box(a, b, c, d); });
                principal.compare(PrincipalInertia<Real>::valid(a, b, c), [&] { PrincipalInertia<Real>(a, b, c); });
                const Matrix3<Real> I = Vector3<Real>(a, b, c).asDiagonal();
                full.compare(FullInertia<Real>::valid(I), [&] { FullInertia<Real>{I}; });
            }
        }
    }
    // Both answers have occurred.
    for (const Answers& answers : {spring, damped, symmetric, principal, full, uniform, rods, spheres, cubes, cylinders,
                                   capsules, staffs, boxes}) {
        CHECK(answers.yes >= 5);
        CHECK(answers.no >= 5);
    }
}

// All of it is known at compile time: a game's tables of bodies cost nothing at start.
static_assert(Spring(3.0).slope_x() == -9 && DampedSpring(3.0, 0.5).acceleration(1.0, 2.0) == -15);
static_assert(Spring<float>::valid(3) && !Spring<float>::valid(-3) && !DampedSpring<double>::valid(-1, 0));
static_assert(sphere(5.0, 1.0).moment == 2 && cube(6.0, 1.0).moment == 1 && rod(12.0f, 1.0f).moment == 1);
static_assert(cylinder(12.0, 1.0, 3.0).across == 12 && cylinder(12.0, 1.0, 3.0).along == 6);
static_assert(about<Axis::y>(staff(12.0, 2.0, 1.0)).about_z.across == 5 && capsule(1.0, 0.1, 0.5).precession_ratio < 0);
static_assert(valid_capsule(1.0, 0.1, 0.5) && !valid_capsule(1.0, 0.0, 0.5) && !valid_sphere(1.0f, 1e-30f));
static_assert(!UniformInertia<double>::valid(0) && !SymmetricInertia<double>::valid(1, 3));

TEST_CASE("a box of half extents equals the box of twice these sides", "[library]") {
    const PrincipalInertia<double> half = box_of_half_extents(12.0, 0.5, 1.0, 1.5), whole = box(12.0, 1.0, 2.0, 3.0);
    CHECK(half.moments == whole.moments);
    CHECK(half.moments == Vector3<double>(13, 10, 5));
    CHECK_THROWS_MATCHES(box_of_half_extents(1.0, 1.0, 0.0, 1.0), std::invalid_argument,
                         Catch::Matchers::Message("half extent = 0: must be finite and greater than zero"));
}
