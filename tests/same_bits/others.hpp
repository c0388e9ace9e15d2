#pragma once
// A rope, dampers there and back, bodies in lanes, and a capsule on a plane.
#include <timestep/damper_sweep.hpp>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/many_bodies.hpp>
#include <timestep/rigid/plane.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rope.hpp>

#include "hash.hpp"

namespace others {

template <class Real>
void print_rope() {
    using V = Vector3<Real>;
    Rope<V> rope(V(0, 0, 0), V(Real(0.9), Real(0.3), Real(0.1)), 12, Real(0.11), Projectile<V>(V(0, 0, Real(-9.81))));
    Hash hash;
    for (int i = 0; i < bits_steps / 2; ++i) {
        rope.step(Real(0.0173), 5);
        for (const auto& point : rope.points()) hash.add(point.x);
    }
    row(hash, name_of<Real>, "rope", "Verlet, 5 sweeps");
}

template <class Real>
void print_dampers() {
    using V = Vector3<Real>;
    DamperSweep<V> sweep({Real(0.7), 0, Real(1.9)});
    sweep.add(0, 1, V(Real(0.9), Real(0.3), Real(0.1)), Real(31.7));
    sweep.add(2, 0, V(Real(-0.2), Real(1.3), Real(0.7)), Real(0.0113));
    sweep.add(1, 2, V(0, 0, 1), Real(1e5));
    std::vector<V> x{V(1, 2, 3), V(0, 0, 0), V(-1, 0, Real(0.3))}, v(3, V(0, 0, 0));
    Hash hash;
    for (int i = 0; i < bits_steps; ++i) {
        for (std::size_t k : {0u, 2u}) v[k] -= Real(0.0173 * 900) * x[k];
        sweep.there_and_back(v, Real(0.0173));
        for (std::size_t k = 0; k < 3; ++k) x[k] += Real(0.0173) * v[k], hash.add(x[k]);
    }
    row(hash, name_of<Real>, "springs and dampers", "dampers there and back");
}

template <class Real>
void print_lanes() {
    ManyBodies<Real, UniformInertia, SymmetricInertia, PrincipalInertia> all;
    for (int i = 0; i < 5; ++i) {  // which packs of no width are full of
        const Real r = Real(i) / 7;
        const Quaternion<Real> q(1, r, -r, Real(0.3));
        const Vector3<Real> w(r - 1, Real(7.1), r);
        all.add(UniformInertia<Real>(1 + r), q, w);
        all.add(SymmetricInertia<Real>(2 + r, Real(0.7)), q, w);
        all.add(PrincipalInertia<Real>(Real(1.3) + r / 9, Real(2.1), Real(2.9)), q, w);
    }
    Hash hash;
    for (int i = 0; i < bits_steps; ++i) {
        all.step(passive_gyroscopic, Real(0.0073));
        for (std::size_t k = 0; k < 5; ++k) {
            hash.add(all.template state<UniformInertia>(k));
            hash.add(all.template state<SymmetricInertia>(k));
            hash.add(all.template state<PrincipalInertia>(k));
        }
    }
    row(hash, name_of<Real>, "bodies in lanes", PassiveGyroscopic::name);
}

void print_plane() {
    const plane::Capsule<SymmetricInertia<double>> body{capsule(10.3, 0.11, 0.7), 10.3, 0.11, 0.35};
    const plane::Ground ground;
    plane::BodyState m = plane::placed(body, plane::Orientation(0.6, 0, 0.8, 0), plane::V(0.3, 2.1, 17.3), 0.2);
    plane::Contacts contacts;
    Hash hash;
    for (int i = 0; i < bits_steps; ++i) {
        m = plane::step(calm_half_step, body, ground, m, 0.0043, contacts);
        hash.add(m.turning), hash.add(m.x), hash.add(m.v);
    }
    row(hash, "double", "capsule on a plane", CalmHalfStep::name);
}

inline void print_rows() {
    print_rope<float>();
    print_rope<double>();
    print_dampers<float>();
    print_dampers<double>();
    print_lanes<float>();
    print_lanes<double>();
    print_plane();
}

}  // namespace others
