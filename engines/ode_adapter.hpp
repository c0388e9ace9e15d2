#pragma once
/// \file
/// For a game with ODE: bodies that keep their spin, with any rule of this course.

#include <vector>

#include <ode/ode.h>

#include <timestep/rigid/spin_state.hpp>

#include "rule_in_engine.hpp"

namespace timestep {

/// A rule for the gyroscopic torque of bodies in a world of ODE's: half a step of it before the contacts and joints,
/// half between them and the turn, for the reasons that GyroscopicWorld gives.
///
/// ODE solves the contacts and turns the bodies in one call, with nothing to be called in between. So the turn is
/// taken back: `step` lets the rule act, keeps the orientations, lets ODE step, lets the rule act on the spin that
/// the contacts have left, and turns the bodies anew. Any engine that can be stepped, read and written can be
/// helped so.
///
/// Left alone is what is kinematic or disabled (asleep). With a locked axis (moments cannot be infinite
/// in ODE) use a joint. Where a world or a body has a largest angular speed, ODE has applied it before the rule, and
/// again in the next step. A body must be taken out before it is destroyed, and added again with a new mass.
template <class Rule = CalmInEngine>
class OdeGyroscopic {
public:
    /// Takes a body in, after its mass has been set, and switches its own gyroscopic term off. Throws
    /// `std::invalid_argument` where its inertia is that of no body.
    void add(dBodyID body) {
        dMass mass;
        dBodyGetMass(body, &mass);
        Matrix3<double> I;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) I(i, j) = double(mass.I[4 * i + j]);
        const FullInertia<double> inertia(I);
        dBodySetGyroscopicMode(body, 0);
        remove(body);
        bodies_.push_back({body, Quaternion<double>(inertia.axes),
                           Rule::body(inertia.principal.moments.cwiseInverse().eval()), orientation(body)});
    }
    /// Lets a body go, without its own term.
    void remove(dBodyID body) {
        std::erase_if(bodies_, [&](const Body& b) { return b.id == body; });
    }

    /// A step of `h` seconds: `ode_step(world, h)` is `dWorldQuickStep`, `dWorldStep` or what calls them.
    template <class Step>
    void step(const Step& ode_step, dWorldID world, dReal h) {
        for (Body& body : bodies_) {
            body.before = orientation(body.id);
            act(body, double(h) / 2);
        }
        ode_step(world, h);
        for (const Body& body : bodies_)
            if (act(body, double(h) / 2)) turn(body, double(h));
    }

private:
    struct Body {
        dBodyID id;
        Quaternion<double> axes;                        // of the principal moments, in the body
        decltype(Rule::body(Vector3<double>())) known;  // what the rule has computed of them
        Quaternion<double> before;                      // the orientation before the step
    };
    static Quaternion<double> orientation(dBodyID body) {
        const dReal* q = dBodyGetQuaternion(body);
        return {double(q[0]), double(q[1]), double(q[2]), double(q[3])};
    }
    // Gives the body its spin after `h` seconds, if that is another one.
    static bool act(const Body& body, double h) {
        if (!dBodyIsEnabled(body.id) || dBodyIsKinematic(body.id)) return false;
        const Quaternion<double> to_world = body.before * body.axes;
        Vector3<double> w = to_world.conjugate() * spin(body.id);
        if (!Rule::step(body.known, w, h)) return false;
        const Vector3<double> omega = to_world * w;
        dBodySetAngularVel(body.id, dReal(omega.x()), dReal(omega.y()), dReal(omega.z()));
        return true;
    }
    // Turns it anew, by its present spin, from where it was before ODE's step.
    static void turn(const Body& body, double h) {
        const Quaternion<double> q = rotation_by(Vector3<double>(h * spin(body.id))) * body.before;
        const dQuaternion after = {dReal(q.w()), dReal(q.x()), dReal(q.y()), dReal(q.z())};
        dBodySetQuaternion(body.id, after);
    }
    static Vector3<double> spin(dBodyID body) {
        const dReal* w = dBodyGetAngularVel(body);
        return {double(w[0]), double(w[1]), double(w[2])};
    }
    std::vector<Body> bodies_;
};

}  // namespace timestep
