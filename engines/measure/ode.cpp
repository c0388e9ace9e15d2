// ODE: by its own rule, and with others half before its contacts and half after them.

#include "engine.hpp"

#ifdef TIMESTEP_WITH_ODE

#include "engines/ode_adapter.hpp"
#include "rules.hpp"

namespace engines {

namespace {

struct NoRule {};  // ODE's own

template <class Rule>
class OdeWorld : public World {
public:
    explicit OdeWorld(const Wanted& wanted) : smooth_(wanted.smooth) {
        dInitODE2(0);
        dRandSetSeed(0);  // it solves in an order by chance: the same, whatever was measured before
        world_ = dWorldCreate();
        space_ = dSimpleSpaceCreate(nullptr);
        contacts_ = dJointGroupCreate(0);
        dWorldSetGravity(world_, 0, 0, -wanted.gravity);
        dWorldSetAutoDisableFlag(world_, wanted.sleeping);
    }
    ~OdeWorld() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
        dCloseODE();
    }
    void ground() override { dCreatePlane(space_, 0, 0, 1, 0); }
    int add(const Shape& shape, const State& s) override {
        const dBodyID body = dBodyCreate(world_);
        dMass mass;
        const Vector &I = shape.moments, &half = shape.half;
        dMassSetParameters(&mass, shape.mass, 0, 0, 0, I.x(), I.y(), I.z(), 0, 0, 0);
        dBodySetMass(body, &mass);
        const dGeomID geom = shape.kind == Shape::box ? dCreateBox(space_, 2 * half.x(), 2 * half.y(), 2 * half.z())
                                                      : dCreateCapsule(space_, half.x(), 2 * half.z());
        dGeomSetBody(geom, body);
        const dQuaternion q = {s.q.w(), s.q.x(), s.q.y(), s.q.z()};
        dBodySetPosition(body, s.x.x(), s.x.y(), s.x.z());
        dBodySetQuaternion(body, q);
        dBodySetLinearVel(body, s.v.x(), s.v.y(), s.v.z());
        dBodySetAngularVel(body, s.omega.x(), s.omega.y(), s.omega.z());
        if constexpr (!std::is_same_v<Rule, NoRule>) gyroscopic_.add(body);
        bodies_.push_back(body);
        return int(bodies_.size()) - 1;
    }
    void pin(int a, const Vector& on_a, int b, const Vector&) override {
        const dJointID joint = dJointCreateBall(world_, nullptr);
        dJointAttach(joint, bodies_[std::size_t(a)], b < 0 ? nullptr : bodies_[std::size_t(b)]);
        dVector3 at;
        dBodyGetRelPointPos(bodies_[std::size_t(a)], on_a.x(), on_a.y(), on_a.z(), at);
        dJointSetBallAnchor(joint, at[0], at[1], at[2]);
    }
    void step(double h) override {
        dSpaceCollide(space_, this, touch);
        if constexpr (std::is_same_v<Rule, NoRule>)
            dWorldQuickStep(world_, h);
        else
            gyroscopic_.step([](dWorldID world, dReal by) { dWorldQuickStep(world, by); }, world_, h);
        dJointGroupEmpty(contacts_);
    }
    State state(int i) const override {
        const dBodyID body = bodies_[std::size_t(i)];
        const dReal *x = dBodyGetPosition(body), *v = dBodyGetLinearVel(body), *q = dBodyGetQuaternion(body),
                    *w = dBodyGetAngularVel(body);
        return {Vector(x[0], x[1], x[2]), Vector(v[0], v[1], v[2]), Quaternion(q[0], q[1], q[2], q[3]),
                Vector(w[0], w[1], w[2]), !dBodyIsEnabled(body)};
    }

private:
    static void touch(void* data, dGeomID a, dGeomID b) {
        const dBodyID one = dGeomGetBody(a), other = dGeomGetBody(b);
        if (one && other && dAreConnected(one, other)) return;
        OdeWorld& self = *static_cast<OdeWorld*>(data);
        dContact found[8] = {};
        const int n = dCollide(a, b, 8, &found[0].geom, sizeof(dContact));
        const bool rolls = dGeomGetClass(a) == dCapsuleClass || dGeomGetClass(b) == dCapsuleClass;
        for (int i = 0; i < n; ++i) {
            found[i].surface.mode = dContactApprox1 | (rolls && !self.smooth_ ? dContactRolling : 0);
            found[i].surface.mu = self.smooth_ ? 0 : friction;
            found[i].surface.rho = found[i].surface.rho2 = found[i].surface.rhoN = rolling;
            dJointAttach(dJointCreateContact(self.world_, self.contacts_, &found[i]), one, other);
        }
    }
    bool smooth_;
    dWorldID world_;
    dSpaceID space_;
    dJointGroupID contacts_;
    std::vector<dBodyID> bodies_;
    timestep::OdeGyroscopic<std::conditional_t<std::is_same_v<Rule, NoRule>, timestep::CalmInEngine, Rule>> gyroscopic_;
};

template <class Rule>
Engine ode(const std::string& rule) {
    return {"ODE", rule, [](const Wanted& wanted) { return std::make_unique<OdeWorld<Rule>>(wanted); }};
}

}  // namespace

void enter_ode(std::vector<Engine>& engines, std::vector<std::string>&) {
    engines.push_back(ode<NoRule>("as it is"));
    for_each_rule([&](const auto& rule, const std::string& name) {
        engines.push_back(ode<InEngine<std::decay_t<decltype(rule)>>>(name + ", halves"));
    });
}

}  // namespace engines

#else

namespace engines {
void enter_ode(std::vector<Engine>&, std::vector<std::string>& missing) {
    missing.push_back("ODE (package libode-dev)");
}
}  // namespace engines

#endif
