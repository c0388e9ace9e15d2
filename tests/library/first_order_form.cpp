// Bodies as arrays of numbers, and back.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <Eigen/Core>

#include <timestep/first_order_form.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/scene.hpp>

using namespace timestep;

TEMPLATE_TEST_CASE("a state stacked and unstacked is the same state", "[library]", float, double, long double) {
    using Real = TestType;
    using Vector3 = Eigen::Matrix<Real, 3, 1>;
    const State<Real> one{1, 2, 3};
    const auto y = stacked(one);
    STATIC_REQUIRE(std::is_same_v<decltype(y.y), Eigen::Matrix<Real, 2, 1>>);
    CHECK(y.t == 1);
    CHECK(y.y == Eigen::Matrix<Real, 2, 1>(2, 3));
    CHECK(unstacked(y).v == 3);

    const State<Vector3> three{1, Vector3(1, 2, 3), Vector3(4, 5, 6)};
    const auto six = stacked(three);
    STATIC_REQUIRE(std::is_same_v<decltype(six.y), Eigen::Matrix<Real, 6, 1>>);
    CHECK(six.y(2) == 3);
    CHECK(six.y(3) == 4);
    CHECK(unstacked(six).x == three.x);
    CHECK(unstacked(six).v == three.v);
}

TEST_CASE("the rate of an array is (v, a), also of a piece of a larger array", "[library]") {
    const FirstOrderForm form{DampedSpring(2.0, 0.25)};
    CHECK(form(0.0, Eigen::Vector2d(3, 5)) == Eigen::Vector2d(5, -17));
    const Eigen::Vector4d y(9, 3, 5, 9);
    CHECK(form(0.0, y.segment<2>(1)) == Eigen::Vector2d(5, -17));
}

TEST_CASE("the derivative of (v, a) is built from the model's slopes", "[library]") {
    const FirstOrderForm form{DampedSpring(2.0, 0.25)};
    Eigen::Matrix2d expected;
    expected << 0, 1, -4, -1;
    CHECK(form.slope_y(0.0, Eigen::Vector2d(3, 5)) == expected);

    const Scene grenade{Projectile(Eigen::Vector2d(0, -9.81)), Drag(0.5)};
    const Eigen::Vector4d y(1, 2, 3, 4);  // |v| = 5
    Eigen::Matrix4d plane;
    plane << 0, 0, 1, 0,   //
        0, 0, 0, 1,        //
        0, 0, -3.4, -1.2,  //
        0, 0, -1.2, -4.1;
    CHECK((FirstOrderForm{grenade}.slope_y(0.0, y) - plane).norm() < 1e-15);
}
