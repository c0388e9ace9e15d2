#pragma once
// Bodies that turn: by every rule of the course, with every kind of inertia, and in lanes. (The functions of
// gyroscopic.h have these bits: engines/tests.)
#include <type_traits>

#include <timestep/body_solvers.hpp>
#include <timestep/rigid/many_bodies.hpp>
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

inline void print_rows() {
    for_each_body_solver([](const auto& rule, const BodyPrice&) { print_all(rule); });
}

}  // namespace bodies
