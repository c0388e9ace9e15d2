#pragma once
/// \file
/// For a game with Bullet: a world whose bodies keep their spin, with any rule of this course.

#include <cstddef>
#include <vector>

#include <btBulletDynamicsCommon.h>

#include "rule_in_engine.hpp"

namespace timestep {

/// Bullet's world with a rule for the gyroscopic torque: half a step of it before the contacts and joints, and half
/// between them and the turn. Take it where you made a `btDiscreteDynamicsWorld`; `World` may be another that has its
/// two functions.
///
/// The whole step before them, as Bullet's own rule and every callback have it, makes the spin new while the
/// orientation is old: a capsule on its tip may gain energy without end, and a top falls over. The whole step after
/// them breaks what joints have settled: a top runs round too fast. In halves the step is the same from both ends,
/// and neither happens in any scene of the course's benchmark.
///
/// A rule acts in each of Bullet's own substeps. It leaves alone what is static, kinematic or asleep, has
/// a locked axis (a zero in the inertia), or an angular factor other than (1, 1, 1): axes locked in the world. Bullet
/// turns no body by more than π/4 a step: beyond, at 47 rad/s and 60 Hz, the spin is right and the orientation lags
/// behind it, as it does without a rule.
template <class Rule = CalmInEngine, class World = btDiscreteDynamicsWorld>
class GyroscopicWorld : public World {
public:
    using World::World;

    /// As in Bullet; switches the body's own gyroscopic term off. Leave it off.
    void addRigidBody(btRigidBody* body) override {
        switch_off(*body);
        World::addRigidBody(body);
    }
    /// The same with a collision group and a mask.
    void addRigidBody(btRigidBody* body, int group, int mask) override {
        switch_off(*body);
        World::addRigidBody(body, group, mask);
    }

    /// One step of `h` seconds of the rule, for one body.
    static void act(btRigidBody& body, btScalar h) { act(body, h, Known()); }

protected:
    void internalSingleStepSimulation(btScalar h) override {
        act_on_all(h / 2);
        World::internalSingleStepSimulation(h);
    }
    void integrateTransforms(btScalar h) override {
        act_on_all(h / 2);
        World::integrateTransforms(h);
    }

private:
    // What a rule has computed of a body's moments.
    struct Known {
        Vector3<btScalar> inverse_moments = Vector3<btScalar>::Zero();
        decltype(Rule::body(Vector3<btScalar>())) body = Rule::body(Vector3<btScalar>::Zero().eval());
    };
    // `known` is that of the body that stood at its place in the step before: nearly always this one. Other moments
    // make it anew, so that nothing need be told when bodies come and go, or change their mass.
    static void act(btRigidBody& body, btScalar h, Known&& known) { act(body, h, known); }
    static void act(btRigidBody& body, btScalar h, Known& known) {
        if (!body.isActive() || body.isStaticOrKinematicObject()) return;
        const btVector3& factor = body.getAngularFactor();
        if (factor.x() != 1 || factor.y() != 1 || factor.z() != 1) return;
        const btMatrix3x3& axes = body.getWorldTransform().getBasis();
        Vector3<btScalar> omega = numbers(body.getAngularVelocity() * axes);  // in the body: axesᵀ ω
        const Vector3<btScalar> inverse_moments = numbers(body.getInvInertiaDiagLocal());
        if (inverse_moments != known.inverse_moments) known = {inverse_moments, Rule::body(inverse_moments)};
        if (Rule::step(known.body, omega, h))
            body.setAngularVelocity(axes * btVector3(omega.x(), omega.y(), omega.z()));
    }
    void act_on_all(btScalar h) {
        known_.resize(std::size_t(this->m_nonStaticRigidBodies.size()));
        for (int i = 0; i < this->m_nonStaticRigidBodies.size(); ++i)
            act(*this->m_nonStaticRigidBodies[i], h, known_[std::size_t(i)]);
    }
    static void switch_off(btRigidBody& body) {
        body.setFlags(body.getFlags() &
                      ~(BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT | BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD |
                        BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY));
    }
    static Vector3<btScalar> numbers(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
    std::vector<Known> known_;
};

}  // namespace timestep
