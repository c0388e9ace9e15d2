// A body in a world of ODE's, alone and without gravity.

#ifdef TIMESTEP_WITH_ODE

#include <memory>

#include <ode/ode.h>

#include "bodies.hpp"

using namespace timestep;

namespace contest {

namespace {

// A world with one body. ODE is started with the first and stopped with the last.
struct World {
    dWorldID world;
    dBodyID body;

    explicit World(const PrincipalInertia<double>& inertia) {
        dInitODE2(0);
        world = dWorldCreate();
        body = dBodyCreate(world);
        dMass mass;
        const auto& I = inertia.moments;
        dMassSetParameters(&mass, 1, 0, 0, 0, I.x(), I.y(), I.z(), 0, 0, 0);
        dBodySetMass(body, &mass);
        dBodySetGyroscopicMode(body, 1);
        dWorldQuickStep(world, 0.01);  // allocates its memory in the first step
    }
    ~World() {
        dWorldDestroy(world);
        dCloseODE();
    }
    World(const World&) = delete;
};

// ODE steps worlds, not bodies: the time includes the search for bodies that touch and the contact solver, both without
// work here. Its gyroscopic solver is the passive step's rule (I − h[L]) ω₂ = Iω₁, in world coordinates with two 3×3
// inverses. It updates the orientation as we do, q + h/2 ω q scaled back, unless dBodySetFiniteRotationMode selects the
// exponential map.
struct OdeBody {
    std::shared_ptr<World> in;
    RigidState<double> start;

    void restart() {
        const dQuaternion q{start.q.w(), start.q.x(), start.q.y(), start.q.z()};
        dBodySetQuaternion(in->body, q);
        dBodySetAngularVel(in->body, start.omega.x(), start.omega.y(), start.omega.z());
    }
    void step(double h) { dWorldQuickStep(in->world, h); }
    void count(Work& work, double) const { ++work.evaluations, ++work.solves; }
    Place place() const {
        const dReal* R = dBodyGetRotation(in->body);  // three rows of four
        Place place;                                  // column by column, as ours
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) place.push_back(R[4 * j + i]);
        return place;
    }
    double number() const { return dBodyGetQuaternion(in->body)[0]; }
};

}  // namespace

void enter_ode(Scene& scene, const PrincipalInertia<double>& inertia, const RigidState<double>& start,
               const std::string& which) {
    const OdeBody body{std::make_shared<World>(inertia), start};
    scene.entries.push_back(stepped("passive" + which + ", in a world's step", "ODE", body));
}

}  // namespace contest

#endif
