// The adapter for Bullet, in Bullet.

#include <cmath>
#include <limits>
#include <memory>

#include <catch2/catch_test_macros.hpp>

#include <timestep/gyroscopic/calm_half_step.hpp>

#include "engines/bullet_adapter.hpp"
#include "scenes.hpp"

namespace {

using timestep::GyroscopicWorld;

constexpr btScalar h = btScalar(1) / 60;
const btVector3 brick(13, 10, 5);  // moments of a box, kg m²

// A world without a ground and without gravity, and one body in it.
template <class World>
struct Alone {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    World world{&dispatcher, &broadphase, &solver, &configuration};
    btBoxShape shape{btVector3(btScalar(0.5), 1, btScalar(1.5))};
    btRigidBody body;

    Alone(const btVector3& omega, const btVector3& moments = brick)
        : body(btRigidBody::btRigidBodyConstructionInfo(12, nullptr, &shape, moments)) {
        world.setGravity({0, 0, 0});
        body.setAngularVelocity(omega);
        body.setSleepingThresholds(0, 0);
        world.addRigidBody(&body);
    }
    ~Alone() { world.removeRigidBody(&body); }
    void steps(int n) {
        for (int i = 0; i < n; ++i) world.stepSimulation(h, 1, h);
    }
    btVector3 in_body() const { return body.getAngularVelocity() * body.getWorldTransform().getBasis(); }
    double energy() const {
        const btVector3 w = in_body();
        return 0.5 * double(w.dot(w * brick));
    }
};

const btVector3 tumbling(btScalar(0.1), 10, btScalar(0.1));

bool same(const btVector3& a, const btVector3& b) { return a.x() == b.x() && a.y() == b.y() && a.z() == b.z(); }

}  // namespace

TEST_CASE("In Bullet's world a box tumbles for a minute and keeps its energy; by Bullet's own it does not",
          "[engines]") {
    Alone<GyroscopicWorld<>> ours(tumbling);
    Alone<btDiscreteDynamicsWorld> bullets(tumbling);
    const double first = ours.energy();
    double off = 0;
    bool flipped = false;
    for (int n = 0; n < 3600; ++n) {
        ours.steps(1), bullets.steps(1);
        off = std::max(off, std::fabs(ours.energy() / first - 1));
        flipped = flipped || ours.in_body().y() < -9;
    }
    CHECK(flipped);
    CHECK(off < 0.001);  // 3600 turns into the world and back in float, ε each, are below 0.0005
    CHECK(bullets.energy() < 0.5 * first);
}

TEST_CASE("One step in Bullet is two halves of the rule's, and nothing else's", "[engines]") {
    Alone<GyroscopicWorld<>> scene({1, 2, 3});
    CHECK((scene.body.getFlags() & BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY) == 0);
    btRigidBody in_a_group(btRigidBody::btRigidBodyConstructionInfo(12, nullptr, &scene.shape, brick));
    scene.world.addRigidBody(&in_a_group, 1, 1);
    CHECK((in_a_group.getFlags() & BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY) == 0);
    scene.world.removeRigidBody(&in_a_group);
    const timestep::PrincipalInertia<btScalar> inertia(13, 10, 5);
    timestep::Vector3<btScalar> expected(1, 2, 3);
    for (int half = 0; half < 2; ++half) expected = timestep::calm_half_step.step(inertia, expected, h / 2);
    scene.steps(1);
    // The body stood in the world's axes, so this is ω in them; a roundoff or two of |ω| by way of 1/I.
    const btVector3& w = scene.body.getAngularVelocity();
    CHECK((timestep::Vector3<btScalar>(w.x(), w.y(), w.z()) - expected).norm() < 8e-7f * 3.75f);
    // And the turn is by the new spin.
    const btQuaternion turned(btVector3(expected.x(), expected.y(), expected.z()).normalized(), expected.norm() * h);
    CHECK(std::fabs(turned.dot(scene.body.getOrientation())) > 1 - 1e-6f);
}

TEST_CASE("Bullet's own substeps are the rule's, too", "[engines]") {
    Alone<GyroscopicWorld<>> one(tumbling), two(tumbling);
    for (int n = 0; n < 30; ++n) two.world.stepSimulation(2 * h, 2, h);
    one.steps(60);
    CHECK(same(one.body.getAngularVelocity(), two.body.getAngularVelocity()));
    CHECK(one.in_body().y() != tumbling.y());
}

TEST_CASE("A body in Bullet whose mass or place in the world changes has its own moments' rule", "[engines]") {
    const btVector3 long_one(2, 3, 5), spin(1, 2, 3);
    Alone<GyroscopicWorld<>> changed(tumbling), fresh(spin, long_one);
    changed.steps(3);  // the world knows the brick's moments now
    changed.body.setMassProps(12, long_one);
    changed.body.setWorldTransform(fresh.body.getWorldTransform());
    changed.body.updateInertiaTensor();
    changed.body.setAngularVelocity(spin), changed.body.setInterpolationAngularVelocity(spin);
    changed.steps(1), fresh.steps(1);
    CHECK(same(changed.body.getAngularVelocity(), fresh.body.getAngularVelocity()));
    CHECK(!same(changed.body.getAngularVelocity(), spin));
    // Another body stands at its place.
    changed.world.removeRigidBody(&changed.body);
    btRigidBody ball(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &changed.shape, btVector3(2, 2, 2)));
    ball.setAngularVelocity(spin), ball.setSleepingThresholds(0, 0);
    changed.world.addRigidBody(&ball);
    changed.steps(1);
    CHECK(same(ball.getAngularVelocity(), spin));
    changed.world.removeRigidBody(&ball);
    changed.world.addRigidBody(&changed.body);
}

TEST_CASE("Where the rule has no business in Bullet, the spin stays", "[engines]") {
    const btVector3 spin(1, 2, 3);
    SECTION("a locked axis") {
        Alone<GyroscopicWorld<>> scene(spin, btVector3(13, 0, 5));
        scene.steps(10);
        CHECK(same(scene.body.getAngularVelocity(), spin));
    }
    SECTION("moments that no body has, by the library's templates") {
        using Rule = timestep::RuleInEngine<timestep::CalmHalfStep>;
        Alone<GyroscopicWorld<Rule>> scene(spin, btVector3(13, 1, 5));
        scene.steps(10);
        CHECK(same(scene.body.getAngularVelocity(), spin));
    }
    SECTION("an axis locked in the world, or two: a body that turns about what is left, as it did") {
        for (const btVector3& factor :
             {btVector3(0, 1, 1), btVector3(1, 0, 1), btVector3(1, 1, 0), btVector3(0, 1, 0)}) {
            const btVector3 left = spin * factor;
            Alone<GyroscopicWorld<>> scene(left);
            scene.body.setWorldTransform(btTransform(btQuaternion(btVector3(1, 2, -1).normalized(), 1)));
            scene.body.updateInertiaTensor();
            scene.body.setAngularFactor(factor);
            scene.steps(60);
            CHECK(same(scene.body.getAngularVelocity(), left));
        }
    }
    SECTION("asleep") {
        Alone<GyroscopicWorld<>> scene(spin);
        scene.body.forceActivationState(ISLAND_SLEEPING);
        GyroscopicWorld<>::act(scene.body, h);
        CHECK(same(scene.body.getAngularVelocity(), spin));
    }
    SECTION("kinematic") {
        Alone<GyroscopicWorld<>> scene(spin);
        scene.body.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
        GyroscopicWorld<>::act(scene.body, h);
        CHECK(same(scene.body.getAngularVelocity(), spin));
    }
    SECTION("a ball") {
        Alone<GyroscopicWorld<>> scene(spin, btVector3(2, 2, 2));
        scene.steps(10);
        CHECK(same(scene.body.getAngularVelocity(), spin));
    }
    SECTION("and of a free body it does not") {
        Alone<GyroscopicWorld<>> scene(spin);
        GyroscopicWorld<>::act(scene.body, h);
        CHECK(!same(scene.body.getAngularVelocity(), spin));
    }
}

namespace {

// A top on a point that holds it, leaning by 0.4 rad: the largest lean of its axis in ten seconds, rad.
template <class World>
double largest_lean() {
    Alone<World> scene({0, 0, 0}, btVector3(btScalar(0.84), btScalar(0.864), btScalar(1.5)));
    scene.world.setGravity({0, 0, btScalar(-9.81)});
    const btTransform place(btQuaternion(btVector3(1, 0, 0), btScalar(0.4)), {0, 0, 0});
    const btVector3 axis = place.getBasis().getColumn(2);
    scene.body.setWorldTransform(place), scene.body.setAngularVelocity(20 * axis);
    scene.body.updateInertiaTensor(), scene.body.setGravity({0, 0, btScalar(-9.81)});
    btPoint2PointConstraint joint(scene.body, {0, 0, btScalar(-0.4)});
    scene.world.addConstraint(&joint);
    double most = 0;
    for (int n = 0; n < 600; ++n) {
        scene.steps(1);
        const double up = double(scene.body.getWorldTransform().getBasis().getColumn(2).z());
        most = std::max(most, std::acos(std::min(1.0, up)));
    }
    scene.world.removeConstraint(&joint);
    return most;
}

}  // namespace

TEST_CASE("In Bullet's world a top stays up, as it truly does; by Bullet's own rule it falls over", "[engines]") {
    // The truth, by chapter 8's benchmark: it never leans by more than 0.59 rad.
    CHECK(largest_lean<GyroscopicWorld<>>() < 0.65);
    CHECK(largest_lean<btDiscreteDynamicsWorld>() > 1);
}

namespace {

// A rule whose numbers are none.
struct Broken {
    template <class Real>
    timestep::Vector3<Real> step(const timestep::PrincipalInertia<Real>&, const timestep::Vector3<Real>& omega,
                                 Real) const {
        return omega * std::numeric_limits<Real>::quiet_NaN();
    }
};

}  // namespace

TEST_CASE("Of a rule of the library an engine gets no spin that is no number, and none for a ball", "[engines]") {
    using Rule = timestep::RuleInEngine<Broken>;
    const auto body = Rule::body(timestep::Vector3<float>(1 / 13.0f, 0.1f, 0.2f));
    REQUIRE(body);
    timestep::Vector3<float> omega(1, 2, 3);
    CHECK(!Rule::step(body, omega, 0.1f));
    CHECK(omega == timestep::Vector3<float>(1, 2, 3));
    CHECK(!Rule::body(timestep::Vector3<float>(2, 2, 2)));
}

// Its turn for two equal moments keeps the energy; the formula for three loses some, and that hides what the contacts
// add.
TEST_CASE(
    "Before Bullet's contacts fast capsules gain energy by the plain passive step, and none by its formula for three "
    "moments",
    "[engines]") {
    std::vector<engines::Engine> all, passive;
    std::vector<std::string> missing;
    engines::enter_bullet(all, missing);
    for (const engines::Engine& engine : all)
        if (engine.rule == "gyroscopic_passivef, before" || engine.rule == "passive, three moments, before")
            passive.push_back(engine);
    REQUIRE(passive.size() == 2);
    engines::Numbers numbers;
    engines::throw_bodies(passive, {}, numbers);
    int seen = 0;
    for (const auto& row : numbers.rows()) {
        if (row.which != "capsule, 30 rad/s" || row.what != "gained a tenth, of a hundred") continue;
        INFO(row.rule << ": " << row.value);
        CHECK((row.rule == "gyroscopic_passivef, before" ? row.value > 5 : row.value == 0));
        ++seen;
    }
    CHECK(seen == 2);
}
