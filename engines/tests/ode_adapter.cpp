// The adapter for ODE, in ODE.

#include <cmath>

#include <catch2/catch_test_macros.hpp>

#include <timestep/gyroscopic/calm_half_step.hpp>

#include "engines/ode_adapter.hpp"

namespace {

using timestep::Quaternion;
using timestep::Vector3;

constexpr double h = 1.0 / 60;

// A world without gravity, one body in it, and the adapter.
struct Alone {
    dWorldID world;
    dBodyID body;
    timestep::OdeGyroscopic<> gyroscopic;

    explicit Alone(const Vector3<double>& omega, double I12 = 0) {
        dInitODE2(0);
        world = dWorldCreate();
        body = dBodyCreate(world);
        dMass mass;
        dMassSetParameters(&mass, 12, 0, 0, 0, 13, 10, 5, I12, 0, 0);
        dBodySetMass(body, &mass);
        dBodySetAngularVel(body, omega.x(), omega.y(), omega.z());
    }
    ~Alone() {
        dWorldDestroy(world);
        dCloseODE();
    }
    Alone(const Alone&) = delete;
    void steps(int n) {
        for (int i = 0; i < n; ++i) gyroscopic.step([](dWorldID w, dReal step) { dWorldQuickStep(w, step); }, world, h);
    }
    Vector3<double> omega() const {
        const dReal* w = dBodyGetAngularVel(body);
        return {w[0], w[1], w[2]};
    }
    Vector3<double> in_body() const {
        const dReal* w = dBodyGetAngularVel(body);
        dVector3 local;
        dBodyVectorFromWorld(body, w[0], w[1], w[2], local);
        return {local[0], local[1], local[2]};
    }
    double energy(double I12 = 0) const {
        timestep::Matrix3<double> I;
        I << 13, I12, 0, I12, 10, 0, 0, 0, 5;
        return in_body().dot(I * in_body()) / 2;
    }
};

const Vector3<double> tumbling(0.1, 10, 0.1);

}  // namespace

TEST_CASE("In ODE a box tumbles for a minute and keeps its energy; by ODE's own it does not", "[engines]") {
    for (const double I12 : {0.0, 0.5}) {  // principal axes are the body's, or turned in it
        Alone ours(tumbling, I12), odes(tumbling, I12);
        ours.gyroscopic.add(ours.body);
        const double first = ours.energy(I12);
        double off = 0, least = 0;
        for (int n = 0; n < 3600; ++n) {
            ours.steps(1), odes.steps(1);
            off = std::max(off, std::fabs(ours.energy(I12) / first - 1));
            least = std::min(least, ours.in_body().y());
        }
        CHECK(least < -9);   // it has flipped
        CHECK(off < 1e-11);  // 3600 steps of some roundoffs each
        CHECK(odes.energy(I12) < 0.9 * first);
    }
}

TEST_CASE("One step in ODE is two halves of the rule's, the turn is by its spin, and nothing else acts", "[engines]") {
    Alone scene({1, 2, 3});
    scene.gyroscopic.add(scene.body);
    const timestep::PrincipalInertia<double> inertia(13, 10, 5);
    Vector3<double> expected(1, 2, 3);
    for (int half = 0; half < 2; ++half) expected = timestep::calm_half_step.step(inertia, expected, h / 2);
    scene.steps(1);
    CHECK((scene.omega() - expected).norm() < 1e-14);
    const timestep::Quaternion<double> turned = timestep::rotation_by(Vector3<double>(h * expected));
    const dReal* q = dBodyGetQuaternion(scene.body);
    CHECK(timestep::apart(turned, timestep::Quaternion<double>(q[0], q[1], q[2], q[3])) < 1e-14);
}

TEST_CASE("Where the rule has no business in ODE, the spin stays", "[engines]") {
    const Vector3<double> spin(1, 2, 3);
    Alone scene(spin);
    scene.gyroscopic.add(scene.body);
    SECTION("kinematic") {
        dBodySetKinematic(scene.body);
        scene.steps(3);
        CHECK(scene.omega() == spin);
    }
    SECTION("disabled") {
        dBodyDisable(scene.body);
        scene.steps(3);
        CHECK(scene.omega() == spin);
    }
    SECTION("let go, it has no gyroscopic torque at all") {
        scene.gyroscopic.remove(scene.body);
        scene.steps(3);
        CHECK((scene.omega() - spin).norm() < 1e-14);
    }
    SECTION("a ball keeps every bit") {
        dMass ball;
        dMassSetParameters(&ball, 12, 0, 0, 0, 10, 10, 10, 0, 0, 0);
        dBodySetMass(scene.body, &ball);
        const Quaternion<double> q = Quaternion<double>(0.9, 0.3, -0.2, 0.4).normalized();
        const dQuaternion tilted = {q.w(), q.x(), q.y(), q.z()};
        dBodySetQuaternion(scene.body, tilted);
        scene.gyroscopic.add(scene.body);
        scene.steps(3);
        CHECK(scene.omega() == spin);
    }
    SECTION("added twice, it is one body") {
        scene.gyroscopic.add(scene.body);
        scene.steps(1);
        Alone once(spin);
        once.gyroscopic.add(once.body);
        once.steps(1);
        CHECK(scene.omega() == once.omega());
        CHECK(scene.omega() != spin);
    }
}

namespace {

// A body on a hinge along the world's y, which is none of its principal axes, turned at 5 rad/s for a minute: what is
// left of that, and the most that its axis was off, rad.
struct Hinged {
    double left = 0, off = 0;
};
template <class Prepare>
Hinged hinged(const Prepare& prepare) {
    Alone scene({0, 5, 0});
    const Quaternion<double> tilted = Quaternion<double>(0.9, 0.3, -0.2, 0.4).normalized();
    const dQuaternion q = {tilted.w(), tilted.x(), tilted.y(), tilted.z()};
    dBodySetQuaternion(scene.body, q);
    const dJointID hinge = dJointCreateHinge(scene.world, nullptr);
    dJointAttach(hinge, scene.body, nullptr);
    dJointSetHingeAnchor(hinge, 0, 0, 0), dJointSetHingeAxis(hinge, 0, 1, 0);
    prepare(scene);
    const Vector3<double> in_body = tilted.conjugate() * Vector3<double>::UnitY();
    Hinged end;
    for (int n = 0; n < 3600; ++n) {
        scene.steps(1);
        const dReal* now = dBodyGetQuaternion(scene.body);
        const Vector3<double> axis = Quaternion<double>(now[0], now[1], now[2], now[3]) * in_body;
        end.off = std::max(end.off, axis.cross(Vector3<double>::UnitY()).norm());
    }
    end.left = scene.omega().y() / 5;
    return end;
}

}  // namespace

TEST_CASE("In ODE, whose locks are joints, a hinged body keeps its spin best without a rule", "[engines]") {
    const Hinged with = hinged([](Alone& scene) { scene.gyroscopic.add(scene.body); });
    CHECK(with.left > 0.9);
    CHECK(with.off < 0.01);                   // half of the rule acts after the joint
    CHECK(hinged([](Alone&) {}).left < 0.5);  // ODE's own
    const Hinged without = hinged([](Alone& scene) { dBodySetGyroscopicMode(scene.body, 0); });
    CHECK(std::fabs(without.left - 1) < 1e-9);
    CHECK(without.off < 1e-9);
}
