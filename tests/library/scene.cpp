// Scenes: the sum of their parts, of the kind that their parts allow, and nothing more.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <Eigen/LU>

#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/models/tether.hpp>
#include <timestep/scene.hpp>

using namespace timestep;
using Vector2 = Eigen::Vector2d;

namespace {

const Projectile fall(-9.81);
const Spring spring(8.0);
const DampedSpring damped(8.0, 0.1);
const Drag drag(0.006);
const Projectile fall2(Vector2(0, -9.81));
const Tether tether(3.0, 1.0);

struct Noisy {  // depends on the velocity, and has no derivatives
    double acceleration(double, double v) const { return v > 0 ? -1 : 1; }
};

struct Brake {  // a = −k v³: the slope along x is a constant, that along v is not
    double acceleration(double, double v) const { return -5 * v * v * v; }
    double slope_x() const { return 0; }
    double slope_v(double, double v) const { return -15 * v * v; }
};

struct HalfNoisy {  // depends on the velocity, and has no derivative by it
    double acceleration(double x, double v) const { return v > 0 ? -x : x; }
    double slope_x() const { return 0; }
};

}  // namespace

TEST_CASE("a scene takes the arguments that its parts take", "[library]") {
    STATIC_REQUIRE(ConstantForce<Scene<Projectile<double>>>);
    STATIC_REQUIRE(ConstantForce<Scene<Projectile<double>, Projectile<double>>>);

    STATIC_REQUIRE(PositionForce<Scene<Spring<double>, Projectile<double>>, double>);
    STATIC_REQUIRE(!ConstantForce<Scene<Spring<double>, Projectile<double>>>);

    using Velocity = Scene<Projectile<double>, Spring<double>, Drag<double>>;
    STATIC_REQUIRE((VelocityForce<Velocity, double> && !PositionForce<Velocity, double>));

    // Two dimensions of gravity do not fit one of position.
    STATIC_REQUIRE(PositionForce<Scene<Spring<double>, Projectile<Vector2>>, Vector2>);
}

TEST_CASE("a scene is linear when all of its parts are, smooth when all of them are", "[library]") {
    STATIC_REQUIRE(LinearForce<Scene<Spring<double>, Projectile<double>>, double>);
    STATIC_REQUIRE(LinearForce<Scene<Projectile<double>, DampedSpring<double>>, double>);
    STATIC_REQUIRE(!LinearForce<Scene<Spring<double>, Drag<double>>, double>);
    STATIC_REQUIRE(SmoothForce<Scene<Spring<double>, Drag<double>>, double>);
    STATIC_REQUIRE(SmoothForce<Scene<Tether<double>, Spring<double>>, Vector2>);
    STATIC_REQUIRE(!SmoothForce<Scene<Spring<double>, Noisy>, double>);

    // Both slopes count, also of a scene within a scene.
    using Nested = Scene<Projectile<double>, Scene<DampedSpring<double>, Brake>>;
    STATIC_REQUIRE((!LinearForce<Nested, double> && SmoothForce<Nested, double>));
    STATIC_REQUIRE(!SmoothForce<Scene<DampedSpring<double>, HalfNoisy>, double>);
}

// A tether with a damper: only the damping has to be linear where nothing else is solved for.
TEST_CASE("damping at the new velocity takes any force of the position beside a linear damper", "[library][N25]") {
    struct Damper {
        double rate;
        Vector2 acceleration(const Vector2&, const Vector2& v) const { return -rate * v; }
        double slope_x() const { return 0; }
        double slope_v() const { return -rate; }
    };
    using Roped = Scene<Tether<double>, Damper>;
    STATIC_REQUIRE((LinearDamping<Roped, Vector2> && !LinearForce<Roped, Vector2>));
    STATIC_REQUIRE(!LinearDamping<Scene<Tether<double>, Drag<double>>, Vector2>);

    const Roped roped{tether, Damper{200}};
    const State<Vector2> one{0, Vector2(1.5, 0.3), Vector2(3, -2)};
    const double h = 1.0 / 60;
    const auto two = semi_implicit_euler_new_damping.step(roped, one, h);
    const Vector2 pull = tether.acceleration(one.x);
    // v₂ = v₁ + h (a(x₁) − c v₂)
    CHECK((two.v - (one.v + h * (pull - 200 * two.v))).norm() < 1e-14 * 200);
    CHECK((two.x - (one.x + h * two.v)).norm() < 1e-15);
}

TEST_CASE("the acceleration is the sum in the order of the parts, bit for bit", "[library]") {
    CHECK(Scene{fall, Projectile(3.1)}.acceleration() == -9.81 + 3.1);
    const double x = 0.3, v = -2.7;
    CHECK(Scene{spring, fall}.acceleration(x) == spring.acceleration(x) + fall.acceleration());
    CHECK(Scene{damped, fall, drag}.acceleration(x, v) ==
          (damped.acceleration(x, v) + fall.acceleration()) + drag.acceleration(x, v));
    // Added from the right, the one would drown in the large numbers.
    const Projectile up(1e16), down(-1e16), one(1.0);
    CHECK(Scene{up, down, one}.acceleration() == 1);
    CHECK(Scene{Spring(0.0), up, down, one}.acceleration(x) == 1);
    CHECK(Scene{Drag(0.0), up, down, one}.acceleration(x, v) == 1);

    // Two parts of one kind are two forces.
    CHECK(Scene{spring, Spring(2.0)}.acceleration(x) == spring.acceleration(x) + Spring(2.0).acceleration(x));
    // A scene is a model, so it can be a part.
    CHECK(Scene{Scene{spring, fall}, drag}.acceleration(x, v) ==
          Scene{spring, fall}.acceleration(x) + drag.acceleration(x, v));
}

TEST_CASE("the slopes are the sums of the slopes", "[library]") {
    CHECK(Scene{spring, fall}.slope_x() == -64);
    CHECK(Scene{fall, damped, Spring(6.0)}.slope_x() == -100);
    CHECK(Scene{damped, DampedSpring(1.0, 0.5)}.slope_v() == damped.slope_v() - 1);

    // A number among matrices stands for itself times the unit matrix.
    const CoupledSprings row(Vector2(1, 2), Eigen::Vector3d(1, 2, 3));
    const Eigen::Matrix2d both = Scene{row, Spring(3.0), fall2}.slope_x();
    CHECK(both == Eigen::Matrix2d(row.slope_x() - 9 * Eigen::Matrix2d::Identity()));

    const Vector2 p(0.3, 1.2), u(4, -5);
    CHECK(Scene{tether, drag, damped}.slope_x(p, u) ==
          Eigen::Matrix2d(tether.slope_x(p) - 64 * Eigen::Matrix2d::Identity()));
    CHECK(slope_v(Scene{fall, Scene{damped, Brake()}}, 1.0, 2.0) == damped.slope_v() - 60);
    CHECK(Scene{tether, drag, damped}.slope_v(p, u) ==
          Eigen::Matrix2d(drag.slope_v(p, u) + damped.slope_v() * Eigen::Matrix2d::Identity()));
}

TEST_CASE("a scene holds its parts and nothing else", "[library]") {
    STATIC_REQUIRE(sizeof(Scene<Spring<double>>) == sizeof(Spring<double>));
    STATIC_REQUIRE(sizeof(Scene<DampedSpring<double>, Projectile<double>>) == 3 * sizeof(double));
    CHECK(Scene{spring}.acceleration(0.3) == spring.acceleration(0.3));
}
