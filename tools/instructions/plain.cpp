// Takes a number of gyroscopic steps, in float, with the spin in the world and the orientation at hand, as an engine
// has them, by one rule or by several, one after the other: a program for a profiler to count. `plain library calm
// 1000` takes the library's templates, `plain any calm 1000` them for a body whose kind is not known before, `plain
// functions calm 1000` those of gyroscopic.h, and `plain bullet own 1000` Bullet's rule. With `calm_in_body` and so on
// the spin is in the body's axes, with `calm_in_double` the numbers are double, with `calm_capsule` two moments are
// equal.

#include <cstdio>
#include <cstdlib>
#include <string>
#include <type_traits>

#include <timestep/gyroscopic.h>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/any_inertia.hpp>
#include <timestep/rigid/body.hpp>

#include "count.hpp"

#ifdef TIMESTEP_WITH_BULLET
#include <BulletDynamics/Dynamics/btRigidBody.h>
#endif

namespace {

using namespace timestep;

template <class Inertia>
struct Body {
    using Real = typename Inertia::Scalar;
    Inertia inertia;
    std::conditional_t<std::is_same_v<Real, float>, gyroscopic_bodyf, gyroscopic_body> plain;
    Quaternion<Real> q;
    Vector3<Real> omega;
    AnyInertia<Real> any;
};

// Each in a function that is called, or a compiler may take several bodies at once: an engine's are not so handy.
// What it calls stands in it (flatten), with each of the three alike.
template <class Solver, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void library(const Solver& solver, Body<Inertia>& b, Real h) {
    b.omega = after_gyroscopic_torque(solver, b.inertia, b.q, b.omega, h);
}
template <class Solver, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void library_in_body(const Solver& solver, Body<Inertia>& b, Real h) {
    if constexpr (Inertia::gyroscopic) b.omega = solver.step(b.inertia, b.omega, h);
}
// The same where the kind is asked in every step, as gyroscopic.h's functions do.
template <class Solver, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void any(const Solver& solver, Body<Inertia>& b, Real h) {
    b.omega = std::visit([&](const auto& inertia) { return after_gyroscopic_torque(solver, inertia, b.q, b.omega, h); },
                         b.any.kind());
}
template <class Solver, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void any_in_body(const Solver& solver, Body<Inertia>& b, Real h) {
    b.omega = b.any.step(solver, b.omega, h);
}
// gyroscopic.h's, by whose name a solver goes.
template <auto rule, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void functions(Body<Inertia>& b, Real h) {
    rule(&b.plain, b.q.coeffs().data(), b.omega.data(), h);
}
template <auto rule, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void functions_in_body(Body<Inertia>& b, Real h) {
    rule(&b.plain, b.omega.data(), h);
}

template <class Inertia, class Step>
bool keep(Body<Inertia> b, long n, const Step& step) {
    const auto h = typename Inertia::Scalar(0.001f) * b.omega.x();  // nor this
    for (long i = 0; i < n; ++i) step(b, h);
    kept = double(b.omega.sum());
    return true;
}

// Takes the rule of that name, if it is this one. `in_body` and `in_world` are gyroscopic.h's.
template <auto in_body, auto in_world, class Solver, class Inertia>
bool by(const std::string& name, const Solver& solver, const Body<Inertia>& b, const std::string& whose,
        const std::string& rule, long n) {
    using Real = typename Inertia::Scalar;
    if (whose == "library" && rule == name) return keep(b, n, [&](auto& body, Real h) { library(solver, body, h); });
    if (whose == "any" && rule == name) return keep(b, n, [&](auto& body, Real h) { any(solver, body, h); });
    if (whose == "any" && rule == name + "_in_body")
        return keep(b, n, [&](auto& body, Real h) { any_in_body(solver, body, h); });
    if (whose == "functions" && rule == name)
        return keep(b, n, [](auto& body, Real h) { functions<in_world>(body, h); });
    if (whose == "library" && rule == name + "_in_body")
        return keep(b, n, [&](auto& body, Real h) { library_in_body(solver, body, h); });
    return whose == "functions" && rule == name + "_in_body" &&
           keep(b, n, [](auto& body, Real h) { functions_in_body<in_body>(body, h); });
}

// All rules of one body, whose kind is the end of their names: nothing, `_capsule`, `_ball`; and of its type of number.
template <class Real, class Inertia>
bool of_body(const std::string& kind, const Inertia& inertia, Real x, Real y, Real z, const std::string& whose,
             const std::string& rule, long n) {
    const Real size = Real(unknown_one);
    const Quaternion<Real> q = Quaternion<Real>(size, 2, 3, 4).normalized();
    if constexpr (std::is_same_v<Real, float>) {
        const Body<Inertia> b{inertia, gyroscopic_from_momentsf(x, y, z), q, {size, 2, 3}, AnyInertia<Real>({x, y, z})};
        return by<gyroscopic_passivef, gyroscopic_passive_in_worldf>("passive" + kind, passive_gyroscopic, b, whose,
                                                                     rule, n) ||
               by<gyroscopic_half_stepf, gyroscopic_half_step_in_worldf>("half_step" + kind, half_step_jacobian, b,
                                                                         whose, rule, n) ||
               by<gyroscopic_calm_half_stepf, gyroscopic_calm_half_step_in_worldf>("calm" + kind, calm_half_step, b,
                                                                                   whose, rule, n);
    } else {
        const Body<Inertia> b{inertia, gyroscopic_from_moments(x, y, z), q, {size, 2, 3}, AnyInertia<Real>({x, y, z})};
        return by<gyroscopic_passive, gyroscopic_passive_in_world>("passive" + kind, passive_gyroscopic, b, whose, rule,
                                                                   n) ||
               by<gyroscopic_half_step, gyroscopic_half_step_in_world>("half_step" + kind, half_step_jacobian, b, whose,
                                                                       rule, n) ||
               by<gyroscopic_calm_half_step, gyroscopic_calm_half_step_in_world>("calm" + kind, calm_half_step, b,
                                                                                 whose, rule, n);
    }
}
template <class Real>
bool of_number(const std::string& number, const std::string& whose, const std::string& rule, long n) {
    const Real size = Real(unknown_one);
    return of_body<Real>(number, PrincipalInertia<Real>(size, 2, Real(2.5)), size, 2, Real(2.5), whose, rule, n) ||
           of_body<Real>("_capsule" + number, SymmetricInertia<Real>(2, size), 2, 2, size, whose, rule, n) ||
           of_body<Real>("_ball" + number, UniformInertia<Real>(size), size, size, size, whose, rule, n);
}

void take(const std::string& whose, const std::string& rule, long n) {
    if (of_number<float>("", whose, rule, n) || of_number<double>("_in_double", whose, rule, n)) return;
#ifdef TIMESTEP_WITH_BULLET
    if (whose == "bullet") {
        const float size = float(unknown_one);
        const Quaternion<float> q = Quaternion<float>(size, 2, 3, 4).normalized();
        btRigidBody body(10, nullptr, nullptr, btVector3(btScalar(size), 2, btScalar(2.5)));
        btTransform place(btQuaternion(btScalar(q.x()), btScalar(q.y()), btScalar(q.z()), btScalar(q.w())));
        body.setCenterOfMassTransform(place);
        body.setAngularVelocity(btVector3(btScalar(size), 2, 3));
        for (long i = 0; i < n; ++i)
            body.setAngularVelocity(body.getAngularVelocity() +
                                    body.computeGyroscopicImpulseImplicit_Body(btScalar(0.001)));
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
