// Gyroscopic steps as an engine takes them: the spin in the world, the orientation at hand. By the library's templates
// for this kind of body ("library_calm") and for any kind ("any_calm"), by the plain functions of gyroscopic.h
// ("functions_calm"), and by Bullet's own rule ("bullet_own"). Endings of the name: "_capsule" has two equal moments,
// "_in_double" computes in double, "_in_body" keeps the spin in the axes of the body.

#include <type_traits>

#include <timestep/gyroscopic.h>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/rigid/any_inertia.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "cases.hpp"

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

// Each step is a function that is called: a compiler could otherwise step several bodies at once, which an engine's
// layout does not allow. What the function calls is inlined in it (flatten, and the parameter in CMakeLists.txt), for
// all three alike.
template <class Solver, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void library(const Solver& solver, Body<Inertia>& b, Real h) {
    b.omega = after_gyroscopic_torque(solver, b.inertia, b.q, b.omega, h);
}
template <class Solver, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void library_in_body(const Solver& solver, Body<Inertia>& b, Real h) {
    if constexpr (Inertia::gyroscopic) b.omega = solver.step(b.inertia, b.omega, h);
}
// Here every step asks for the kind of body, as gyroscopic.h's functions do.
template <class Solver, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void any(const Solver& solver, Body<Inertia>& b, Real h) {
    b.omega = std::visit([&](const auto& inertia) { return after_gyroscopic_torque(solver, inertia, b.q, b.omega, h); },
                         b.any.kind());
}
template <class Solver, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void any_in_body(const Solver& solver, Body<Inertia>& b, Real h) {
    b.omega = b.any.step(solver, b.omega, h);
}
template <auto rule, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void functions(Body<Inertia>& b, Real h) {
    rule(&b.plain, b.q.coeffs().data(), b.omega.data(), h);
}
template <auto rule, class Inertia, class Real>
[[gnu::noinline, gnu::flatten]] void functions_in_body(Body<Inertia>& b, Real h) {
    rule(&b.plain, b.omega.data(), h);
}

template <class Inertia, class Step>
void keep(Body<Inertia> b, long n, const Step& step) {
    const auto h = typename Inertia::Scalar(0.001f) * b.omega.x();  // not known to the compiler either
    for (long i = 0; i < n; ++i) step(b, h);
    kept = double(b.omega.sum());
}

// One rule of one body. `in_body` and `in_world` are gyroscopic.h's.
template <auto in_body, auto in_world, class Solver, class Inertia>
void add(std::vector<Case>& all, const std::string& rule, const Solver& solver, const Body<Inertia>& b) {
    using Real = typename Inertia::Scalar;
    const auto add = [&](const std::string& name, const auto& step) {
        all.push_back({name, 1000, [=](long n) { keep(b, n, step); }});
    };
    add("library_" + rule, [=](auto& body, Real h) { library(solver, body, h); });
    add("any_" + rule, [=](auto& body, Real h) { any(solver, body, h); });
    add("functions_" + rule, [](auto& body, Real h) { functions<in_world>(body, h); });
    add("library_" + rule + "_in_body", [=](auto& body, Real h) { library_in_body(solver, body, h); });
    add("any_" + rule + "_in_body", [=](auto& body, Real h) { any_in_body(solver, body, h); });
    add("functions_" + rule + "_in_body", [](auto& body, Real h) { functions_in_body<in_body>(body, h); });
}

// All rules of one body, whose kind ends their names.
template <class Inertia, class Real>
void add_rules(std::vector<Case>& all, const std::string& kind, const Inertia& inertia, Real x, Real y, Real z) {
    const Real size = Real(unknown_one);
    const Quaternion<Real> q = Quaternion<Real>(size, 2, 3, 4).normalized();
    // Two equal moments turn by one formula, whatever the rule: one rule is counted.
    constexpr bool three = std::is_same_v<Inertia, PrincipalInertia<Real>>;
    if constexpr (std::is_same_v<Real, float>) {
        const Body<Inertia> b{inertia, gyroscopic_from_momentsf(x, y, z), q, {size, 2, 3}, AnyInertia<Real>({x, y, z})};
        if constexpr (three) {
            add<gyroscopic_passivef, gyroscopic_passive_in_worldf>(all, "passive" + kind, passive_gyroscopic, b);
            add<gyroscopic_half_stepf, gyroscopic_half_step_in_worldf>(all, "half_step" + kind, half_step_jacobian, b);
        }
        add<gyroscopic_calm_half_stepf, gyroscopic_calm_half_step_in_worldf>(all, "calm" + kind, calm_half_step, b);
    } else {
        const Body<Inertia> b{inertia, gyroscopic_from_moments(x, y, z), q, {size, 2, 3}, AnyInertia<Real>({x, y, z})};
        if constexpr (three) {
            add<gyroscopic_passive, gyroscopic_passive_in_world>(all, "passive" + kind, passive_gyroscopic, b);
            add<gyroscopic_half_step, gyroscopic_half_step_in_world>(all, "half_step" + kind, half_step_jacobian, b);
        }
        add<gyroscopic_calm_half_step, gyroscopic_calm_half_step_in_world>(all, "calm" + kind, calm_half_step, b);
    }
}

template <class Real>
void add_bodies(std::vector<Case>& all, const std::string& number) {
    const Real size = Real(unknown_one);
    add_rules(all, number, PrincipalInertia<Real>(size, 2, Real(2.5)), size, Real(2), Real(2.5));
    add_rules(all, "_capsule" + number, SymmetricInertia<Real>(2, size), Real(2), Real(2), size);
    add_rules(all, "_ball" + number, UniformInertia<Real>(size), size, size, size);
}

#ifdef TIMESTEP_WITH_BULLET
void bullet(long n) {
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
}
#endif

// The library's solvers in double. The orientation stays, as only the solver is counted.
template <class Solver, class Inertia>
[[gnu::noinline]] Vector3<double> spin(const Solver& solver, const Inertia& inertia, const Matrix3<double>& R,
                                       Vector3<double> omega, long n) {
    for (long i = 0; i < n; ++i) omega = after_gyroscopic_torque(solver, inertia, R, omega, 0.001);
    return omega;
}

template <class Solver>
void add_solver(std::vector<Case>& all, const std::string& name, const Solver& solver) {
    const double size = unknown_one;
    const Matrix3<double> R = Quaternion<double>(size, 2, 3, 4).normalized().toRotationMatrix();
    const auto add_body = [&](const std::string& body, const auto& inertia) {
        all.push_back({name + "_" + body, 1000,
                       [=](long n) { kept = spin(solver, inertia, R, Vector3<double>(size, 2, 3), n).sum(); }});
    };
    const auto sides = box(10.0, size, 2.0, 3.0);
    const Matrix3<double> turned = R * sides.moments.asDiagonal() * R.transpose();
    add_body("ball", sphere(10.0, size));
    add_body("capsule", capsule(10.0, size, 2.0));
    add_body("box", sides);
    add_body("any", FullInertia<double>((turned + turned.transpose()) / 2));
}

}  // namespace

std::vector<Case> functions_for_c() {
    std::vector<Case> all;
    add_bodies<float>(all, "");
    add_bodies<double>(all, "_in_double");
#ifdef TIMESTEP_WITH_BULLET
    all.push_back({"bullet_own", 1000, bullet});
#endif
    return all;
}

std::vector<Case> gyroscopic_solvers() {
    std::vector<Case> all;
    add_solver(all, "explicit", explicit_gyroscopic);
    add_solver(all, "iteration", implicit_gyroscopic);
    add_solver(all, "passive", passive_gyroscopic);
    return all;
}
