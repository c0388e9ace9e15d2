// Takes a number of gyroscopic steps, in float, with the spin in the world and the orientation at hand, as an engine has
// them, by one rule or by several, one after the other: a program for a profiler to count. `plain library calm 1000` takes the library's
// templates, `plain functions calm 1000` those of gyroscopic.h, and `plain bullet own 1000` Bullet's rule. With
// `calm_in_body` and so on the spin is in the body's axes.

#include <cstdio>
#include <cstdlib>
#include <string>

#include <timestep/gyroscopic.h>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/body.hpp>

#include "count.hpp"

#ifdef TIMESTEP_WITH_BULLET
#include <BulletDynamics/Dynamics/btRigidBody.h>
#endif

namespace {

using namespace timestep;

struct Body {
    PrincipalInertia<float> inertia;
    gyroscopic_bodyf plain;
    Quaternion<float> q;
    Vector3<float> omega;
};

// Each in a function that is called, or a compiler may take several bodies at once: an engine's are not so handy.
template <class Solver>
[[gnu::noinline]] void library(const Solver& solver, Body& b, float h) {
    b.omega = after_gyroscopic_torque(solver, b.inertia, b.q, b.omega, h);
}
template <class Solver>
[[gnu::noinline]] void library_in_body(const Solver& solver, Body& b, float h) {
    b.omega = solver.step(b.inertia, b.omega, h);
}
[[gnu::noinline]] void passive_in_body(Body& b, float h) { gyroscopic_passivef(&b.plain, b.omega.data(), h); }
[[gnu::noinline]] void half_step_in_body(Body& b, float h) { gyroscopic_half_stepf(&b.plain, b.omega.data(), h); }
[[gnu::noinline]] void calm_in_body(Body& b, float h) { gyroscopic_calm_half_stepf(&b.plain, b.omega.data(), h); }
[[gnu::noinline]] void passive(Body& b, float h) {
    gyroscopic_passive_in_worldf(&b.plain, b.q.coeffs().data(), b.omega.data(), h);
}
[[gnu::noinline]] void half_step(Body& b, float h) {
    gyroscopic_half_step_in_worldf(&b.plain, b.q.coeffs().data(), b.omega.data(), h);
}
[[gnu::noinline]] void calm(Body& b, float h) {
    gyroscopic_calm_half_step_in_worldf(&b.plain, b.q.coeffs().data(), b.omega.data(), h);
}

template <class Step>
void keep(const Step& step, Body b, long n) {
    for (long i = 0; i < n; ++i) step(b, 0.001f);
    kept = double(b.omega.sum());
}

void take(const std::string& whose, const std::string& rule, long n) {
    const float size = float(unknown_one);
    const Body b{{size, 2, 2.5f}, gyroscopic_from_momentsf(size, 2, 2.5f),
                 Quaternion<float>(size, 2, 3, 4).normalized(), {size, 2, 3}};
    const auto by = [&](const auto& solver) {
        return keep([&](Body& body, float h) { library(solver, body, h); }, b, n);
    };
    const auto by_in_body = [&](const auto& solver) {
        return keep([&](Body& body, float h) { library_in_body(solver, body, h); }, b, n);
    };
    if (whose == "library" && rule == "passive_in_body") return by_in_body(passive_gyroscopic);
    if (whose == "library" && rule == "half_step_in_body") return by_in_body(half_step_jacobian);
    if (whose == "library" && rule == "calm_in_body") return by_in_body(calm_half_step);
    if (whose == "functions" && rule == "passive_in_body") return keep(passive_in_body, b, n);
    if (whose == "functions" && rule == "half_step_in_body") return keep(half_step_in_body, b, n);
    if (whose == "functions" && rule == "calm_in_body") return keep(calm_in_body, b, n);
    if (whose == "library" && rule == "passive") return by(passive_gyroscopic);
    if (whose == "library" && rule == "half_step") return by(half_step_jacobian);
    if (whose == "library" && rule == "calm") return by(calm_half_step);
    if (whose == "functions" && rule == "passive") return keep(passive, b, n);
    if (whose == "functions" && rule == "half_step") return keep(half_step, b, n);
    if (whose == "functions" && rule == "calm") return keep(calm, b, n);
    if (whose == "functions" && rule == "ball")
        return keep(calm, {b.inertia, gyroscopic_from_momentsf(size, size, size), b.q, b.omega}, n);
#ifdef TIMESTEP_WITH_BULLET
    if (whose == "bullet") {
        btRigidBody body(10, nullptr, nullptr, btVector3(btScalar(size), 2, btScalar(2.5)));
        btTransform place(btQuaternion(btScalar(b.q.x()), btScalar(b.q.y()), btScalar(b.q.z()), btScalar(b.q.w())));
        body.setCenterOfMassTransform(place);
        body.setAngularVelocity(btVector3(btScalar(size), 2, 3));
        for (long i = 0; i < n; ++i)
            body.setAngularVelocity(body.getAngularVelocity() + body.computeGyroscopicImpulseImplicit_Body(btScalar(0.001)));
        kept = double(body.getAngularVelocity().x());
        return;
    }
#endif
    std::exit((std::fprintf(stderr, "plain: %s %s: no such step\n", whose.c_str(), rule.c_str()), 2));
}

}  // namespace

int main(int argc, char** argv) {
    const auto one = [](char** words, long n) { take(words[0], words[1], n); };
    if (!count_all(argc, argv, 2, one)) return std::fputs("plain: usage: plain WHOSE RULE COUNT ...\n", stderr), 2;
}
