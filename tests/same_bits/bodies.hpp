#pragma once
// Bodies that turn, by every rule of the course, with every kind of inertia that it takes.
#include <type_traits>

#include <timestep/body_solvers.hpp>
#include <timestep/rigid/symmetric_about.hpp>

#include "hash.hpp"

namespace bodies {

template <class Real, class Rule, class Inertia>
void print(const char* scene, const Rule& rule, const Inertia& I) {
    SpinState<Real> s{0, Quaternion<Real>(Real(0.6), Real(0), Real(-0.8), Real(0)),
                      Vector3<Real>(Real(0.3), Real(7.1), Real(-0.9))};
    Hash hash;
    for (int i = 0; i < bits_steps; ++i) {
        s = rule.step(I, s, Real(0.0073));
        hash.add(s);
    }
    row(hash, name_of<Real>, scene, Rule::name);
}

template <class Rule>
inline constexpr bool by_remainder = std::is_same_v<Rule, BallAndRemainder2> || std::is_same_v<Rule, BallAndRemainder4>;
template <class Rule>
inline constexpr bool lacks_full = by_remainder<Rule> || std::is_same_v<Rule, Strang>;

template <class Real, class Rule>
void print_all(const Rule& rule) {
    print<Real>("box", rule, PrincipalInertia<Real>(Real(1.3), Real(2.1), Real(2.9)));
    print<Real>("rod", rule, PrincipalInertia<Real>(Real(0.007), Real(2.1), Real(2.103)));
    if constexpr (!std::is_same_v<Rule, Strang>) {
        const SymmetricInertia<Real> staff(Real(2.3), Real(0.17));
        print<Real>("staff", rule, staff);
        print<Real>("staff along x", rule, about<Axis::x>(staff));
    }
    if constexpr (!lacks_full<Rule>) {
        Matrix3<Real> any;
        any << Real(2.1), Real(0.3), Real(-0.2), Real(0.3), Real(1.7), Real(0.4), Real(-0.2), Real(0.4), Real(2.6);
        print<Real>("full matrix", rule, FullInertia<Real>(any));
    }
}

inline void print_rows() {
    for_each_body_solver([](const auto& rule, const BodyPrice&) {
        print_all<float>(rule);
        print_all<double>(rule);
    });
}

}  // namespace bodies
