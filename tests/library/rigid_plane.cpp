// The capsule on a plane: contacts, friction and rolling resistance.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <timestep/gyroscopic/no_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/plane.hpp>
#include <timestep/rigid/shapes.hpp>

#include "random_inertia.hpp"

using namespace timestep;
using plane::Contacts;
using plane::V;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double h = 1.0 / 60;

// 90 cm long, 30 cm thick, 1 kg.
const plane::Capsule<SymmetricInertia<double>> pill{capsule(1.0, 0.15, 0.6), 1.0, 0.15, 0.3};
const plane::Capsule<UniformInertia<double>> ball{sphere(1.0, 0.15), 1.0, 0.15, 0.0};

plane::Ground rough(double rolling) { return {9.81, 0.5, rolling, plane::Arms::middle}; }

template <class Solver, class Inertia, class Look>
plane::BodyState run(const Solver& solver, const plane::Capsule<Inertia>& body, const plane::Ground& ground,
                     plane::BodyState m, long steps, const Look& look) {
    Contacts contacts;
    for (long n = 0; n < steps; ++n) {
        const plane::BodyState before = m;
        m = plane::step(solver, body, ground, m, h, contacts);
        if (!look(before, m, contacts)) break;
    }
    return m;
}

// From half a metre up, turning about any axis.
plane::BodyState any_throw(RandomInertia& random) {
    const V axis = random.direction<double>();
    const plane::Orientation q(Eigen::AngleAxisd(1 + axis.x(), random.direction<double>()));
    return plane::placed(pill, q, 40 * axis, 0.5);
}
const auto to_the_end = [](const auto&...) { return true; };
bool at_rest(const plane::BodyState& m) { return m.turning.omega.norm() < 1e-3 && m.v.norm() < 1e-3; }

}  // namespace

TEST_CASE("impulses keep to their cones", "[library][N49]") {
    RandomInertia random(3);
    bool slid = false, pressed = false;
    for (int i = 0; i < 12; ++i) {
        const plane::Ground ground = rough(0.1);
        run(passive_gyroscopic, pill, ground, any_throw(random), 300,
            [&](const auto&, const auto&, const Contacts& contacts) {
                double normal = 0;
                for (int k = 0; k < contacts.count; ++k) {
                    const auto& c = contacts.at[k];
                    REQUIRE(c.normal >= 0);
                    REQUIRE(c.friction.norm() <= ground.friction * c.normal * (1 + 4 * eps));
                    slid = slid || (c.normal > 0 && c.friction.norm() > ground.friction * c.normal * (1 - 4 * eps));
                    normal += c.normal;
                }
                REQUIRE(contacts.rolling.norm() <= ground.rolling * pill.radius * normal * (1 + 4 * eps));
                pressed = pressed || normal > 0;
                return true;
            });
    }
    CHECK(slid);
    CHECK(pressed);
}

TEST_CASE("a capsule that lies still stays, carried by its weight", "[library][N49]") {
    const Quaternion<double> lying(Eigen::AngleAxisd(std::acos(-1.0) / 2, V::UnitY()));
    const plane::BodyState start{{0, lying, V::Zero()}, {0, 0, pill.radius}, V::Zero()};
    const auto end =
        run(no_gyroscopic, pill, rough(0.0), start, 600, [&](const auto&, const auto&, const Contacts& contacts) {
            const double carried = contacts.at[0].normal + contacts.at[1].normal;
            // Each round of sequential impulses halves what is wrong, or better.
            REQUIRE(std::fabs(carried / (9.81 * h) - 1) < std::pow(0.5, 12));
            return true;
        });
    CHECK((end.x - start.x).norm() < 1e-3 * pill.radius);
    CHECK(end.turning.q.angularDistance(lying) < 1e-3);
}

TEST_CASE("rolling resistance stops a ball when it should", "[library][N49]") {
    // Angular impulse c r m g a second against the roll, about the line of contact: the ball has
    // 7/5 m r v there, so it slows by 5/7 c g. Without resistance it rolls on.
    const double v = 2, c = 0.1, slowing = 5.0 / 7 * c * 9.81;
    auto start = plane::placed(ball, Quaternion<double>::Identity(), V(0, v / ball.radius, 0));
    start.v = {v, 0, 0};
    double stopped = -1;
    const auto end =
        run(passive_gyroscopic, ball, rough(c), start, 600, [&](const auto&, const auto& m, const Contacts&) {
            if (stopped < 0 && at_rest(m)) stopped = m.turning.t;
            return true;
        });
    CHECK(std::fabs(stopped - v / slowing) <= 2 * h);  // whole steps, and one until 1 mm/s
    // Semi-implicit: the sum of the new speeds, short of ½ v²/slowing by half a step of the first
    // speed.
    CHECK(std::fabs(end.x.x() - v * v / slowing / 2) < v * h);
    const auto on = run(passive_gyroscopic, ball, rough(0.0), start, 600, to_the_end);
    CHECK(std::fabs(on.v.x() - v) < 1e-10);
}
