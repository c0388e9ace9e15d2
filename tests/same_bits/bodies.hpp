#pragma once
// Bodies that turn: by every rule of the course, with every kind of inertia; in lanes; on a plane; and by the plain
// functions of gyroscopic.h.
#include <type_traits>

#include <timestep/body_solvers.hpp>
#include <timestep/gyroscopic.h>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/many_bodies.hpp>
#include <timestep/rigid/plane.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/symmetric_about.hpp>

#include "hash.hpp"

namespace bodies {

template <class Rule, class InertiaOf>
void print(const char* scene, const Rule& rule, const InertiaOf& inertia_of) {
    row(scene, Rule::name, [&]<class Real>(Hash& hash) {
        const auto inertia = inertia_of(Real());
        SpinState<Real> s{0, Quaternion<Real>(Real(0.6), Real(0), Real(-0.8), Real(0)),
                          Vector3<Real>(Real(0.3), Real(7.1), Real(-0.9))};
        for (int i = 0; i < steps; ++i) {
            s = rule.step(inertia, s, Real(0.0073));
            hash.add(s);
        }
    });
}

template <class Rule>
inline constexpr bool lacks_full =
    std::is_same_v<Rule, BallAndRemainder2> || std::is_same_v<Rule, BallAndRemainder4> || std::is_same_v<Rule, Strang>;

template <class Rule>
void print_all(const Rule& rule) {
    print("box", rule, []<class Real>(Real) { return PrincipalInertia<Real>(Real(1.3), Real(2.1), Real(2.9)); });
    print("rod", rule, []<class Real>(Real) { return PrincipalInertia<Real>(Real(0.007), Real(2.1), Real(2.103)); });
    if constexpr (!std::is_same_v<Rule, Strang>) {
        const auto staff = []<class Real>(Real) { return SymmetricInertia<Real>(Real(2.3), Real(0.17)); };
        print("staff", rule, staff);
        print("staff along x", rule, [&](auto real) { return about<Axis::x>(staff(real)); });
    }
    if constexpr (!lacks_full<Rule>)
        print("full matrix", rule, []<class Real>(Real) {
            Matrix3<Real> any;
            any << Real(2.1), Real(0.3), Real(-0.2), Real(0.3), Real(1.7), Real(0.4), Real(-0.2), Real(0.4), Real(2.6);
            return FullInertia<Real>(any);
        });
}

inline void print_lanes() {
    row("bodies in lanes", PassiveGyroscopic::name, []<class Real>(Hash& hash) {
        ManyBodies<Real, UniformInertia, SymmetricInertia, PrincipalInertia> all;
        for (int i = 0; i < 5; ++i) {  // which packs of no width are full of
            const Real r = Real(i) / 7;
            const Quaternion<Real> q(1, r, -r, Real(0.3));
            const Vector3<Real> w(r - 1, Real(7.1), r);
            all.add(UniformInertia<Real>(1 + r), q, w);
            all.add(SymmetricInertia<Real>(2 + r, Real(0.7)), q, w);
            all.add(PrincipalInertia<Real>(Real(1.3) + r / 9, Real(2.1), Real(2.9)), q, w);
        }
        for (int i = 0; i < steps; ++i) {
            all.step(passive_gyroscopic, Real(0.0073));
            for (std::size_t k = 0; k < 5; ++k) {
                hash.add(all.template state<UniformInertia>(k));
                hash.add(all.template state<SymmetricInertia>(k));
                hash.add(all.template state<PrincipalInertia>(k));
            }
        }
    });
}

inline void print_plane() {
    row("capsule on a plane", CalmHalfStep::name, []<class Real>(Hash& hash) {
        if constexpr (std::is_same_v<Real, double>) {  // the plane is of double alone
            const plane::Capsule<SymmetricInertia<double>> body{capsule(10.3, 0.11, 0.7), 10.3, 0.11, 0.35};
            const plane::Ground ground;
            auto m = plane::placed(body, plane::Orientation(0.6, 0, 0.8, 0), plane::V(0.3, 2.1, 17.3), 0.2);
            plane::Contacts contacts;
            for (int i = 0; i < steps; ++i) {
                m = plane::step(calm_half_step, body, ground, m, 0.0043, contacts);
                hash.add(m.turning), hash.add(m.x), hash.add(m.v);
            }
        }
    });
}

// A function of gyroscopic.h, in float or in double.
template <class Real, class InFloat, class InDouble>
auto choose(InFloat in_float, InDouble in_double) {
    if constexpr (std::is_same_v<Real, float>)
        return in_float;
    else
        return in_double;
}

#define IN_C(function) choose<Real>(function##f, function)

template <class Step>
void print_in_c(const char* scene, const char* name, const Step& step) {
    row(scene, name, [&]<class Real>(Hash& hash) {
        const auto body = IN_C(gyroscopic_from_moments)(Real(1.3), Real(2.1), Real(2.9));
        Real w[3] = {Real(0.3), Real(7.1), Real(-0.9)}, v[3] = {Real(0.3), Real(7.1), Real(-0.9)};
        Real q[4] = {Real(0.1), Real(-0.5), Real(0.7), Real(0.5)};
        for (int i = 0; i < steps; ++i) step(hash, body, q, w, v);
    });
}

#define PRINT_IN_C(name, rule)                                                                                         \
    print_in_c("in C, body and world", name, []<class Real>(Hash& hash, const auto& body, Real* q, Real* w, Real* v) { \
        IN_C(gyroscopic_##rule)(&body, w, Real(0.0073));                                                               \
        IN_C(gyroscopic_##rule##_in_world)(&body, q, v, Real(0.0073));                                                 \
        for (int k = 0; k < 3; ++k) hash.add(w[k]), hash.add(v[k]);                                                    \
    })
#define PRINT_FLYING(name, rule)                                                                             \
    print_in_c("in C, flying", name, []<class Real>(Hash& hash, const auto& body, Real* q, Real* w, Real*) { \
        IN_C(gyroscopic_##rule)(&body, q, w, Real(0.0073));                                                  \
        for (int k = 0; k < 3; ++k) hash.add(w[k]);                                                          \
        for (int k = 0; k < 4; ++k) hash.add(q[k]);                                                          \
    })

inline void print_rows() {
    for_each_body_solver([](const auto& rule, const BodyPrice&) { print_all(rule); });
    PRINT_IN_C("passive", passive);
    PRINT_IN_C("half step", half_step);
    PRINT_IN_C("calm half step", calm_half_step);
    PRINT_FLYING("ball and remainder 2", ball_and_remainder_2);
    PRINT_FLYING("ball and remainder 4", ball_and_remainder_4);
}

}  // namespace bodies
