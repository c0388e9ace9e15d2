// Bullet's and ODE's gyroscopic solvers beside ours, where they are installed.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#ifdef TIMESTEP_WITH_BULLET
#include <BulletDynamics/Dynamics/btRigidBody.h>
#endif
#ifdef TIMESTEP_WITH_ODE
#include <ode/ode.h>
#endif

#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/body.hpp>

#include "contest/scenes.hpp"
#include "random_inertia.hpp"

using namespace contest;
using namespace timestep;

namespace {

#if defined(TIMESTEP_WITH_BULLET) || defined(TIMESTEP_WITH_ODE)
// How far two entries of a scene are apart after the first `looked_at` marks.
double apart(const Scene& scene, const std::string& method, const std::string& their_method, const std::string& library,
             long steps, int looked_at) {
    const Entry *ours = nullptr, *theirs = nullptr;
    for (const Entry& entry : scene.entries) {
        if (entry.method == method && entry.library == "Timestep") ours = &entry;
        if (entry.method == their_method && entry.library == library) theirs = &entry;
    }
    REQUIRE(ours != nullptr);
    REQUIRE(theirs != nullptr);
    const Track a = ours->track(steps), b = theirs->track(steps);
    double largest = 0;
    for (int i = 0; i < looked_at; ++i) largest = std::max(largest, distance(scene, a[i], b[i]));
    return largest;
}
#endif

}  // namespace

#ifdef TIMESTEP_WITH_BULLET

TEST_CASE("Bullet's solver is ours of one iteration, in body and in world coordinates", "[N48][ch7]") {
    using Real = btScalar;
    const double epsilon = std::numeric_limits<Real>::epsilon();
    RandomInertia random(7);
    for (int i = 0; i < 1000; ++i) {
        // No smaller: where the determinant is below ε, Bullet takes the matrix for singular.
        const PrincipalInertia<double> like = random.inertia<double>(5);
        const Vector3<Real> I = (like.moments / like.moments.maxCoeff()).cast<Real>();
        const PrincipalInertia<Real> inertia(I.x(), I.y(), I.z());
        const Vector3<Real> axis = random.direction<Real>();
        const Vector3<Real> omega = Real(10) * random.direction<Real>();
        const Real h = Real(1) / 60;
        const Quaternion<Real> q(Eigen::AngleAxis<Real>(Real(i) / 300, axis));
        const Vector3<Real> after = after_gyroscopic_torque(implicit_gyroscopic, inertia, q, omega, h);

        btRigidBody body(1, nullptr, nullptr, btVector3(I.x(), I.y(), I.z()));
        btTransform place = btTransform::getIdentity();
        place.setRotation(btQuaternion(q.x(), q.y(), q.z(), q.w()));
        body.setWorldTransform(place);
        body.setAngularVelocity(btVector3(omega.x(), omega.y(), omega.z()));
        const btVector3 changes[] = {body.computeGyroscopicImpulseImplicit_Body(h),
                                     body.computeGyroscopicImpulseImplicit_World(h)};
        // Into body coordinates and back, by matrix and by quaternion: 8 roundings each, of ω. The
        // solve, by Cramer's rule, some 30 of ω's change, times the condition of I and I + hG: that is
        // the ratio of the moments, twice.
        const double ratio = I.maxCoeff() / I.minCoeff();
        const double bound = epsilon * (32 * omega.norm() + 30 * 2 * ratio * (after - omega).norm());
        for (const btVector3& change : changes) {
            const Vector3<Real> theirs = omega + Vector3<Real>(change.x(), change.y(), change.z());
            CHECK(double((theirs - after).norm()) < bound);
        }
    }
}

TEST_CASE("Bullet's runs are ours", "[N48][ch7]") {
    // A step is off by some 32 ε of ω, so n steps by n² h |ω| 16 ε if nothing makes it grow: for the
    // capsule, at 60 Hz and 6 rad/s, 0.01. In the box the difference grows as the tumble does, by
    // e^(4.8 t/s): we look at the first half second, in which 16 n² ε h |ω| e^2.4 is 0.003.
    const std::string method = "one Newton step";
    const std::string real = sizeof(btScalar) == sizeof(float) ? ", float" : "";
    const std::string three = method + ", three moments" + real;
    CHECK(apart(symmetric_top(), three, three, "Bullet", 240, marks) < 0.01);
    CHECK(apart(dzhanibekov(), method + real, method + real, "Bullet", 240, 4) < 0.003);
}

#endif

#ifdef TIMESTEP_WITH_ODE

namespace {

// One body in a world of ODE's.
struct OdeRun {
    dWorldID world;
    dBodyID body;

    explicit OdeRun(const Vector3<double>& I) {
        dInitODE2(0);
        world = dWorldCreate();
        body = dBodyCreate(world);
        dMass mass;
        dMassSetParameters(&mass, 1, 0, 0, 0, I.x(), I.y(), I.z(), 0, 0, 0);
        dBodySetMass(body, &mass);
    }
    ~OdeRun() {
        dWorldDestroy(world);
        dCloseODE();
    }
    OdeRun(const OdeRun&) = delete;

    RigidState<double> state() const {
        const dReal *q = dBodyGetQuaternion(body), *w = dBodyGetAngularVel(body);
        return {0, {q[0], q[1], q[2], q[3]}, {w[0], w[1], w[2]}};
    }
};

}  // namespace

TEST_CASE("ODE solves the passive step's equation, and turns the body as we do", "[N51][ch7]") {
    const double epsilon = std::numeric_limits<dReal>::epsilon(), h = 1.0 / 60;
    RandomInertia random(8);
    for (int i = 0; i < 100; ++i) {
        const PrincipalInertia<double> like = random.inertia<double>(5);
        const Vector3<double> I = like.moments / like.moments.maxCoeff();
        const PrincipalInertia<double> inertia(I.x(), I.y(), I.z());
        const double ratio = I.maxCoeff() / I.minCoeff();
        const Vector3<double> omega = 10 * random.direction<double>();
        for (const bool finite : {false, true}) {
            OdeRun run(I);
            CHECK(dBodyGetGyroscopicMode(run.body) != 0);      // on, and
            CHECK(dBodyGetFiniteRotationMode(run.body) == 0);  // off, if nobody says anything
            dBodySetFiniteRotationMode(run.body, finite);
            dBodySetAngularVel(run.body, omega.x(), omega.y(), omega.z());
            for (int n = 0; n < 20; ++n) {
                const RigidState<double> s1 = run.state();
                const Vector3<double> L = angular_momentum(inertia, s1);
                if (n % 2 == 0)
                    dWorldQuickStep(run.world, h);
                else
                    dWorldStep(run.world, h);
                const RigidState<double> s2 = run.state();
                // (I − h[L]) ω₂ = Iω₁ = L in world coordinates, at the old orientation. Two inverses and
                // five products of 3×3, some 100 roundings, times the ratio of the moments.
                const RigidState<double> mixed{0, s1.q, s2.omega};
                const Vector3<double> left = angular_momentum(inertia, mixed) - h * L.cross(s2.omega);
                CHECK((left - L).norm() < 100 * epsilon * ratio * L.norm());
                // Ours, from the same state; the orientation too unless it is told to be finite: then
                // a step turns by h|ω| instead of 2 atan(h|ω|/2), and ω is the same.
                const RigidState<double> ours = step_rotation(passive_gyroscopic, inertia, s1, h);
                CHECK((ours.omega - s2.omega).norm() < 100 * epsilon * ratio * omega.norm());
                const double off = 2 * std::asin((ours.q.conjugate() * s2.q).vec().norm());
                const double angle = h * s2.omega.norm();
                const double expected = finite ? angle - 2 * std::atan(angle / 2) : 0;
                CHECK(std::fabs(off - expected) < 100 * epsilon * ratio);
            }
        }
    }
}

TEST_CASE("ODE's runs are ours", "[N51][ch7]") {
    // As for Bullet, in double: n² h |ω| times 100 ε is 1e-10 for 240 steps; in the box times e^2.4.
    const std::string three = "passive, three moments", world = ", in a world's step";
    CHECK(apart(symmetric_top(), three, three + world, "ODE", 240, marks) < 1e-10);
    CHECK(apart(dzhanibekov(), "passive", "passive" + world, "ODE", 240, 4) < 1e-9);
}

#endif
