// What a force depends on is what its acceleration takes; nothing more reaches it.
#include <catch2/catch_test_macros.hpp>

#include <Eigen/Core>
#include <timestep/forces.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>

using namespace timestep;

namespace {

struct Cubic {  // position only, not linear
    double acceleration(double x) const { return -x * x * x; }
    double slope_x(double x, double) const { return -3 * x * x; }
    double slope_v(double, double) const { return 0; }
};
struct TwoSprings {  // another stiffness in each direction
    Eigen::Vector2d acceleration(const Eigen::Vector2d& x) const { return slope_x() * x; }
    Eigen::Matrix2d slope_x() const { return Eigen::Vector2d(-1, -4).asDiagonal(); }
};

}  // namespace

TEST_CASE("each kind of force is asked with the arguments it takes", "[library]") {
    const Eigen::Vector2d x(2, 0), v(3, 1);
    CHECK(acceleration(Projectile(Eigen::Vector2d(0, -10)), x, v) == Eigen::Vector2d(0, -10));
    CHECK(acceleration(Spring(4.0), x, v) == Eigen::Vector2d(-32, 0));
    CHECK(acceleration(DampedSpring(4.0, 0.5), x, v) == Eigen::Vector2d(-32 - 12, -4));
    CHECK(slope_x(Projectile(-10.0), 2.0, 3.0) == 0);
    CHECK(slope_v(Spring(4.0), 2.0, 3.0) == 0);
    CHECK(slope_x(DampedSpring(4.0, 0.5), 2.0, 3.0) == -16);
    CHECK(slope_v(DampedSpring(4.0, 0.5), 2.0, 3.0) == -4);
    CHECK(slope_x(Cubic(), 2.0, 3.0) == -12);
    CHECK(slope_x(TwoSprings(), x, v) == TwoSprings().slope_x());
}

// A damper in a fluid that gets denser downwards, and a model that offers every overload.
struct DenserBelow {
    double acceleration(double x, double v) const { return slope_v(x) * v; }
    double slope_x() const { return 0; }
    double slope_v(double x) const { return x - 10; }
};
struct Every {
    double acceleration(double x, double v) const { return x + v; }
    double slope_x() const { return 1; }
    double slope_x(double) const { return 2; }
    double slope_x(double, double) const { return 3; }
    double slope_v() const { return 1; }
    double slope_v(double) const { return 2; }
    double slope_v(double, double) const { return 3; }
};

TEST_CASE("both slopes take the overload with the most arguments", "[library]") {
    CHECK(slope_x(Every(), 0.0, 0.0) == 3);
    CHECK(slope_v(Every(), 0.0, 0.0) == 3);
    STATIC_REQUIRE(SmoothForce<DenserBelow, double>);
    CHECK(slope_v(DenserBelow(), 4.0, 1.0) == -6);
}

TEST_CASE("the rate of change of a body is its velocity and its acceleration", "[library]") {
    const Rate<double> r = rate(Spring(4.0), State{7, 2.0, 3.0});
    CHECK(r.x == 3);
    CHECK(r.v == -32);
    CHECK(rate([](double t, double y) { return t + y; }, FirstOrder{7, 2.0}) == 9);
}
