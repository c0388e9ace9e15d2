// Bullet's gyroscopic solver on one body, without a world around it.

#ifdef TIMESTEP_WITH_BULLET

#include <memory>

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "bodies.hpp"

using namespace timestep;

namespace contest {

namespace {

// The two ways that Bullet's sources have to turn a body (btTransformUtil::integrateTransform).
enum class Update {
    exponential,  // by the angle h|ω|, but never more than π/4 a step: the one that is compiled
    derivative    // q + h/2 ω q, scaled back: ours. There it is behind QUATERNION_DERIVATIVE
};

// Bullet keeps the orientation as a matrix, and makes a quaternion of it twice a step.
struct BulletBody {
    std::shared_ptr<btRigidBody> body;
    btVector3 omega;
    Update update;

    void restart() {
        body->setWorldTransform(btTransform::getIdentity());
        body->setAngularVelocity(omega);
    }
    void step(double step) {
        const btScalar h = btScalar(step);
        body->setAngularVelocity(body->getAngularVelocity() + body->computeGyroscopicImpulseImplicit_Body(h));
        btTransform next = body->getWorldTransform();
        if (update == Update::exponential) {
            body->predictIntegratedTransform(h, next);
        } else {
            btQuaternion q = next.getRotation();
            q += (body->getAngularVelocity() * q) * (h * btScalar(0.5));
            next.setRotation(q.safeNormalize());
        }
        body->setWorldTransform(next);
    }
    void count(Work& work, double) const { ++work.evaluations, ++work.solves; }
    Place place() const {
        const btMatrix3x3& R = body->getWorldTransform().getBasis();
        Place place;  // column by column, as ours
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) place.push_back(double(R[j][i]));
        return place;
    }
    btScalar number() const { return body->getWorldTransform().getBasis()[0][0]; }
};

}  // namespace

void enter_bullet(Scene& scene, const PrincipalInertia<double>& inertia, const RigidState<double>& start,
                  const std::string& which) {
    const auto vector = [](const Vector3<double>& v) {
        return btVector3(btScalar(v.x()), btScalar(v.y()), btScalar(v.z()));
    };
    const std::string real = sizeof(btScalar) == sizeof(float) ? ", float" : "";
    for (const Update update : {Update::derivative, Update::exponential}) {
        // Bullet's bodies start with the world's axes, as ours do here.
        const BulletBody body{std::make_shared<btRigidBody>(btScalar(1), nullptr, nullptr, vector(inertia.moments)),
                              vector(start.omega), update};
        const std::string turned = update == Update::exponential ? ", exponential map" : "";
        scene.entries.push_back(stepped("one Newton step" + which + turned + real, "Bullet", body));
    }
}

}  // namespace contest

#endif
