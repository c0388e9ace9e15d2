// Bullet: by its own rule, and with others before its contacts, after them, or half and half.

#include "engine.hpp"

#ifdef TIMESTEP_WITH_BULLET

#include "engines/bullet_adapter.hpp"
#include "rules.hpp"

namespace engines {

namespace {

btVector3 in_bullet(const Vector& v) { return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())}; }
Vector out_of(const btVector3& v) { return {double(v.x()), double(v.y()), double(v.z())}; }

// A rule in a callback before the step, as a game can have it without a class of its own.
template <class Rule>
struct CallbackWorld : btDiscreteDynamicsWorld {
    CallbackWorld(btDispatcher* a, btBroadphaseInterface* b, btConstraintSolver* c, btCollisionConfiguration* d)
        : btDiscreteDynamicsWorld(a, b, c, d) {
        setInternalTickCallback(
            [](btDynamicsWorld* world, btScalar h) {
                for (btRigidBody* body : static_cast<CallbackWorld*>(world)->bodies)
                    timestep::GyroscopicWorld<Rule>::act(*body, h);
            },
            nullptr, true);
    }
    void addRigidBody(btRigidBody* body) override {
        body->setFlags(0);
        bodies.push_back(body);
        btDiscreteDynamicsWorld::addRigidBody(body);
    }
    std::vector<btRigidBody*> bodies;
};

// A rule between contacts and turn, the whole step of it.
template <class Rule>
struct AfterWorld : btDiscreteDynamicsWorld {
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
    void addRigidBody(btRigidBody* body) override {
        body->setFlags(0);
        btDiscreteDynamicsWorld::addRigidBody(body);
    }
    void integrateTransforms(btScalar h) override {
        for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i)
            timestep::GyroscopicWorld<Rule>::act(*m_nonStaticRigidBodies[i], h);
        btDiscreteDynamicsWorld::integrateTransforms(h);
    }
};

template <class Dynamics>
class BulletWorld : public World {
public:
    explicit BulletWorld(const Wanted& wanted) : wanted_(wanted) {
        world_.setGravity({0, 0, btScalar(-wanted.gravity)});
    }
    ~BulletWorld() override {
        for (auto& joint : joints_) world_.removeConstraint(joint.get());
        for (auto& body : bodies_) world_.removeRigidBody(body.get());
        if (ground_) world_.removeCollisionObject(ground_.get());
    }
    void ground() override {
        plane_ = std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0));
        ground_ = std::make_unique<btCollisionObject>();
        ground_->setCollisionShape(plane_.get());
        ground_->setFriction(1);  // Bullet takes the product of both
        world_.addCollisionObject(ground_.get());
    }
    int add(const Shape& shape, const State& s) override {
        if (shape.kind == Shape::box)
            shapes_.push_back(std::make_unique<btBoxShape>(in_bullet(shape.half)));
        else
            shapes_.push_back(
                std::make_unique<btCapsuleShapeZ>(btScalar(shape.half.x()), btScalar(2 * shape.half.z())));
        bodies_.push_back(std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(
            btScalar(shape.mass), nullptr, shapes_.back().get(), in_bullet(shape.moments))));
        btRigidBody& body = *bodies_.back();
        const btQuaternion q(btScalar(s.q.x()), btScalar(s.q.y()), btScalar(s.q.z()), btScalar(s.q.w()));
        const btTransform place(q, in_bullet(s.x));
        body.setWorldTransform(place), body.setInterpolationWorldTransform(place);
        body.setLinearVelocity(in_bullet(s.v)), body.setAngularVelocity(in_bullet(s.omega));
        body.updateInertiaTensor();
        body.setFriction(wanted_.smooth ? 0 : btScalar(friction));
        if (shape.kind == Shape::capsule && !wanted_.smooth) body.setRollingFriction(btScalar(rolling));
        if (!wanted_.sleeping) body.setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(&body);
        return int(bodies_.size()) - 1;
    }
    void pin(int a, const Vector& on_a, int b, const Vector& on_b) override {
        btRigidBody& one = *bodies_[std::size_t(a)];
        if (b < 0)
            joints_.push_back(std::make_unique<btPoint2PointConstraint>(one, in_bullet(on_a)));
        else
            joints_.push_back(std::make_unique<btPoint2PointConstraint>(one, *bodies_[std::size_t(b)], in_bullet(on_a),
                                                                        in_bullet(on_b)));
        world_.addConstraint(joints_.back().get(), true);
    }
    void step(double h) override { world_.stepSimulation(btScalar(h), 1, btScalar(h)); }
    State state(int i) const override {
        const btRigidBody& body = *bodies_[std::size_t(i)];
        const btQuaternion q = body.getWorldTransform().getRotation();
        return {out_of(body.getWorldTransform().getOrigin()), out_of(body.getLinearVelocity()),
                Quaternion(double(q.w()), double(q.x()), double(q.y()), double(q.z())),
                out_of(body.getAngularVelocity()), !body.isActive()};
    }

private:
    Wanted wanted_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    Dynamics world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::unique_ptr<btStaticPlaneShape> plane_;
    std::unique_ptr<btCollisionObject> ground_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

template <class Dynamics>
Engine bullet(const std::string& rule) {
    return {"Bullet", rule, [](const Wanted& wanted) { return std::make_unique<BulletWorld<Dynamics>>(wanted); }};
}

}  // namespace

void enter_bullet(std::vector<Engine>& engines, std::vector<std::string>&) {
    using namespace timestep;
    engines.push_back(bullet<btDiscreteDynamicsWorld>("as it is"));
    engines.push_back(bullet<CallbackWorld<InEngine<PassiveGyroscopic>>>("passive, three moments, before"));
    engines.push_back(bullet<CallbackWorld<PassiveInEngine>>("gyroscopic_passivef, before"));
    engines.push_back(bullet<CallbackWorld<InEngine<CalmHalfStep>>>("calm half-step, before"));
    engines.push_back(bullet<AfterWorld<InEngine<CalmHalfStep>>>("calm half-step, after"));
    for_each_rule([&](const auto& rule, const std::string& name) {
        using Rule = InEngine<std::decay_t<decltype(rule)>>;
        engines.push_back(bullet<GyroscopicWorld<Rule>>(name + ", halves"));
    });
}

}  // namespace engines

#else

namespace engines {
void enter_bullet(std::vector<Engine>&, std::vector<std::string>& missing) {
    missing.push_back("Bullet (package libbullet-dev)");
}
}  // namespace engines

#endif
