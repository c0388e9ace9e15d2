// Capsules thrown onto a plane inside Bullet: it matters where in an engine's step a rule stands.

#include <cstdio>
#include <functional>
#include <string>

#include "sections.hpp"

#ifdef TIMESTEP_WITH_BULLET

#include <algorithm>

#include <btBulletDynamicsCommon.h>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>

#include "random_body.hpp"

namespace {

constexpr int throws_of_each = 50;
constexpr double patience = 10;  // s
constexpr double spin = 30;      // rad/s

using Rule = std::function<Vector(const Body&, const Vector&, double)>;
enum class Place { before_contacts, after_contacts };

// Bullet's step: gravity, contacts, then the turn. Its own gyroscopic rule is switched off, ours comes before the
// contacts are asked, as in a callback, or between them and the turn.
struct World : btDiscreteDynamicsWorld {
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
    btRigidBody* body = nullptr;
    const Body* inertia = nullptr;
    Rule rule;
    Place place = Place::before_contacts;

    void apply(btScalar h) {
        const btMatrix3x3& axes = body->getWorldTransform().getBasis();
        const btVector3 omega = axes.transpose() * body->getAngularVelocity();
        const Vector next = rule(*inertia, Vector(omega.x(), omega.y(), omega.z()), h);
        body->setAngularVelocity(axes * btVector3(btScalar(next.x()), btScalar(next.y()), btScalar(next.z())));
    }
    void internalSingleStepSimulation(btScalar h) override {
        if (place == Place::before_contacts) apply(h);
        btDiscreteDynamicsWorld::internalSingleStepSimulation(h);
    }
    void solveConstraints(btContactSolverInfo& info) override {
        btDiscreteDynamicsWorld::solveConstraints(info);
        if (place == Place::after_contacts) apply(info.m_timeStep);
    }
};

btVector3 in_bullet(const Vector& v) {
    return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

struct Outcome {
    int restless = 0;  // that still move when our patience ends
    double most = 0;   // the most energy that one ever has, over that at the start
};

Outcome thrown(const Rule& rule, Place place) {
    Outcome all;
    RandomBody random(11);
    for (int n = 0; n < throws_of_each; ++n) {
        btDefaultCollisionConfiguration configuration;
        btCollisionDispatcher dispatcher(&configuration);
        btDbvtBroadphase broadphase;
        btSequentialImpulseConstraintSolver solver;
        World world(&dispatcher, &broadphase, &solver, &configuration);
        world.rule = rule, world.place = place;
        world.setGravity({0, btScalar(-9.81), 0});

        btStaticPlaneShape plane({0, 1, 0}, 0);
        btRigidBody ground(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
        ground.setFriction(1);
        world.addRigidBody(&ground);

        const btScalar radius = btScalar(0.25), length = btScalar(0.8);
        btCapsuleShape shape(radius, length);
        btVector3 moments;
        shape.calculateLocalInertia(1, moments);
        const Body inertia(moments.x(), moments.y(), moments.z());
        btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &shape, moments));
        body.setFlags(0);
        body.setFriction(btScalar(0.6)), body.setRollingFriction(btScalar(0.02));
        const Vector turned = random.direction(), axis = random.direction();
        btTransform start(btQuaternion(in_bullet(turned), 2), {0, btScalar(1.5), 0});
        body.setWorldTransform(start), body.setInterpolationWorldTransform(start);
        body.setAngularVelocity(in_bullet(spin * axis));
        body.updateInertiaTensor();
        world.body = &body, world.inertia = &inertia;
        world.addRigidBody(&body);

        const auto energy = [&] {
            const btVector3 omega = body.getWorldTransform().getBasis().transpose() * body.getAngularVelocity();
            return 0.5 * body.getLinearVelocity().length2() + 0.5 * omega.dot(omega * moments) +
                   9.81 * (body.getWorldTransform().getOrigin().y() - radius);
        };
        const double at_start = energy();
        double still = 0;  // for so long, s
        for (double t = 0; t < patience && still < 1; t += 1.0 / 60) {
            world.stepSimulation(btScalar(1.0 / 60), 1, btScalar(1.0 / 60));
            all.most = std::max(all.most, energy() / at_start);
            const bool quiet = body.getAngularVelocity().length() < btScalar(0.2) &&
                               body.getLinearVelocity().length() < btScalar(0.1);
            still = quiet || !body.isActive() ? still + 1.0 / 60 : 0;
        }
        all.restless += still < 1;
        world.removeRigidBody(&body), world.removeRigidBody(&ground);
    }
    return all;
}

}  // namespace

void in_bullet(lab::Findings& out) {
    using namespace timestep;
    out.section("Inside Bullet");
    const auto by = [](const auto& solver) -> Rule {
        return [=](const Body& inertia, const Vector& omega, double h) { return solver.step(inertia, omega, h); };
    };
    // The exact motion, nearly: the calm half-step in 64 pieces.
    const Rule exact = [](const Body& inertia, Vector omega, double h) {
        for (int n = 0; n < 64; ++n) omega = calm_half_step.step(inertia, omega, h / 64);
        return omega;
    };
    auto& table = out.table("in_bullet.tsv", {"rule", "before the contacts", "between contacts and turn"});
    int restless_before[4], restless_after = 0, i = 0;
    double most_after = 0;
    const auto row = [&](const char* name, const Rule& rule) {
        const Outcome before = thrown(rule, Place::before_contacts), after = thrown(rule, Place::after_contacts);
        std::printf("  %-16s restless: %2d before the contacts, energy up to x %.2f; %2d after them, x %.2f\n", name,
                    before.restless, before.most, after.restless, after.most);
        const auto words = [](const Outcome& o) {
            char text[64];
            std::snprintf(text, sizeof text, "%d of %d, energy × %.2g", o.restless, throws_of_each, o.most);
            return std::string(text);
        };
        table.row({std::string(name), words(before), words(after)});
        restless_before[i++] = before.restless;
        restless_after += after.restless;
        most_after = std::max(most_after, after.most);
    };
    row("exact", exact);
    row("calm half-step", by(calm_half_step));
    row("one Newton step", by(implicit_gyroscopic));
    row("passive", by(passive_gyroscopic));
    out.number("in_bullet_throws", throws_of_each, "", "capsules thrown inside Bullet, by each rule");
    out.number("in_bullet_spin", spin, "rad/s", "the spin with which they are thrown");
    out.number("in_bullet_patience", patience, "s", "how long we wait for them to rest");
    out.check("in_bullet_before", restless_before[0] > 0 && restless_before[1] > 0 && restless_before[3] == 0,
              "in Bullet, before the contacts, capsules do not rest by the exact motion nor by the calm half-step, and "
              "all rest by passive");
    out.check("in_bullet_after", restless_after == 0 && most_after < 1.01,
              "between contacts and turn all of them rest by every rule, and none has 1 % more than its first energy");
}

#else

void in_bullet(lab::Findings& out) {
    out.text("in_bullet_throws", "", "not measured: Bullet is not installed");
}

#endif
