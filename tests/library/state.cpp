// States, their rates, bodies as arrays of numbers, and what is deduced from what one writes.
#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>
#include <type_traits>

#include <Eigen/Core>
#include <timestep/first_order_form.hpp>
#include <timestep/methods.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>
#include <timestep/state.hpp>

using namespace timestep;

TEST_CASE("a state is of the type that its values are of", "[library]") {
    STATIC_REQUIRE(std::is_same_v<decltype(State{0, 1.0f, 0.0f}), State<float>>);
    STATIC_REQUIRE(std::is_same_v<decltype(State{0, 1.0, 0.0}), State<double>>);
    STATIC_REQUIRE(std::is_same_v<decltype(State{0, 1.0L, 0.0L}), State<long double>>);
    STATIC_REQUIRE(std::is_same_v<decltype(FirstOrder{0, 1.0f}), FirstOrder<float>>);
    // A whole number beside a real one is meant as a real one.
    STATIC_REQUIRE(std::is_same_v<decltype(State{0, 1, 0.0}), State<double>>);
    STATIC_REQUIRE(std::is_same_v<decltype(State{0, 1.0f, 0}), State<float>>);
}

TEST_CASE("a state keeps vectors, whatever Eigen expression they are written as", "[library]") {
    const Eigen::Vector3d a(1, 2, 3), b(4, 5, 6);
    STATIC_REQUIRE(std::is_same_v<decltype(State{0, a, b}), State<Eigen::Vector3d>>);
    STATIC_REQUIRE(std::is_same_v<decltype(State{0, a, b - a}), State<Eigen::Vector3d>>);
    STATIC_REQUIRE(std::is_same_v<decltype(State{0, a + b, b + a}), State<Eigen::Vector3d>>);
    STATIC_REQUIRE(std::is_same_v<decltype(FirstOrder{0, 2 * a}), FirstOrder<Eigen::Vector3d>>);
    const State s{0, Eigen::Vector3d(a + b), Eigen::Vector3d::Zero()};
    CHECK(s.x == Eigen::Vector3d(5, 7, 9));
    CHECK(s.v == Eigen::Vector3d(0, 0, 0));
}

TEST_CASE("the real number behind a number, a vector and a state", "[library]") {
    STATIC_REQUIRE(std::is_same_v<real_of<float>, float>);
    STATIC_REQUIRE(std::is_same_v<real_of<Eigen::Vector2f>, float>);
    STATIC_REQUIRE(std::is_same_v<real_of<State<Eigen::Vector3d>>, double>);
    STATIC_REQUIRE(std::is_same_v<real_of<FirstOrder<long double>>, long double>);
}

// A game's own vector, which knows nothing of Eigen.
namespace game {

struct Vec3 {
    using Scalar = float;
    float x, y, z;
    friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3 operator*(float s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
    friend Vec3 operator/(const Vec3& a, float s) { return {a.x / s, a.y / s, a.z / s}; }
};
bool is_finite(const Vec3& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

}  // namespace game

// On a spring the coordinates are independent, and the operations are the same.
TEST_CASE("every method steps a vector, Eigen's or a game's own, to the bits of its coordinates", "[library]") {
    STATIC_REQUIRE(StateVector<game::Vec3>);
    STATIC_REQUIRE(StateVector<Eigen::Vector3f>);
    STATIC_REQUIRE(!StateVector<std::array<float, 3>>);
    const State own{0, game::Vec3{1, 2, 3}, game::Vec3{0, 0, 1}};
    const State eigen{0, Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(0, 0, 1)};
    const auto steps = [&](const auto& method) {
        const auto of_own = run(method, Spring(1.5f), own, 0.1f, 10);
        const auto of_eigen = run(method, Spring(1.5f), eigen, 0.1f, 10);
        CAPTURE(method.name);
        for (int i = 0; i < 3; ++i) {
            const auto alone = run(method, Spring(1.5f), State<float>{0, eigen.x(i), eigen.v(i)}, 0.1f, 10);
            CHECK((of_eigen.x(i) == alone.x && of_eigen.v(i) == alone.v && of_eigen.t == alone.t));
            if (i == 2) CHECK((of_own.x.z == alone.x && of_own.v.z == alone.v));
        }
    };
    for_each_method(steps);
    for_each_verlet_method(steps);
}

TEST_CASE("a state stacked and unstacked is the same state", "[library]") {
    const auto two = stacked(State{1, 2.0f, 3.0f});
    STATIC_REQUIRE(std::is_same_v<decltype(two.y), Eigen::Vector2f>);
    CHECK(two.t == 1);
    CHECK(two.y == Eigen::Vector2f(2, 3));
    CHECK(unstacked(two).v == 3);

    const State three{1, Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 5, 6)};
    const auto six = stacked(three);
    STATIC_REQUIRE(std::is_same_v<decltype(six.y), Eigen::Matrix<double, 6, 1>>);
    CHECK((six.y(2) == 3 && six.y(3) == 4));
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
