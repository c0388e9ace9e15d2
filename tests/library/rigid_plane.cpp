// The capsule on a plane: contacts, friction and rolling resistance.

#include <catch2/catch_test_macros.hpp>

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
