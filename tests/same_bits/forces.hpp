#pragma once
// Forces and first-order systems: every method, of numbers and of vectors. Starts and parameters have no short binary
// fraction, and no force needs sin, cos or exp of the mathematical library, whose bits nobody promises.
#include <type_traits>

#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/complex_decay.hpp>
#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/robertson.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/models/tether.hpp>
#include <timestep/models/van_der_pol.hpp>
#include <timestep/run.hpp>

#include "hash.hpp"

namespace forces {

// A spring that stiffens, a = −x − x³: implicit methods need Newton–Raphson.
template <class Real>
struct StiffeningSpring {
    Real acceleration(Real x) const { return -x - x * x * x; }
    Real slope_x(Real x, Real) const { return -1 - 3 * x * x; }
    Real slope_v(Real, Real) const { return 0; }
};

template <class Method, class Model, class Start>
void add_run(Hash& hash, const Method& method, const Model& model, const Start& start, double h = 0.0173) {
    run(method, model, start, decltype(start.t)(h), steps, [&](const auto& s) { hash.add(s); });
}

template <class Real>
const State<Real> start{0, Real(1.1), Real(-0.3)};
template <class Real>
const State<Vector3<Real>> start_in_space{0, Vector3<Real>(Real(1.1), Real(0.7), Real(-0.6)),
                                          Vector3<Real>(Real(0.2), Real(-0.9), Real(3.1))};

template <class Method>
void print_forces(const Method& method) {
    const char* name = Method::name;
    row("spring", name, [&]<class Real>(Hash& h) { add_run(h, method, Spring<Real>(Real(3.1)), start<Real>); });
    row("projectile", name, [&]<class Real>(Hash& h) {
        using V3 = Vector3<Real>;
        add_run(h, method, Projectile<V3>(V3(0, 0, Real(-9.81))), start_in_space<Real>);
    });
    row("coupled springs", name, [&]<class Real>(Hash& h) {
        using V4 = Eigen::Matrix<Real, 4, 1>;
        Eigen::Matrix<Real, 5, 1> stiffness;
        stiffness << Real(10.1), Real(20.3), Real(7.7), Real(0), Real(3.3);
        const V4 masses(Real(1.1), Real(0.7), Real(2.3), Real(0.9));
        const State<V4> first{0, V4(Real(0.1), Real(-0.2), Real(0.3), Real(0.7)), V4::Zero()};
        add_run(h, method, CoupledSprings(masses, stiffness), first);
    });
    if constexpr (!std::is_same_v<Method, SemiImplicitEulerNewDamping>) {
        row("stiffening spring", name,
            [&]<class Real>(Hash& h) { add_run(h, method, StiffeningSpring<Real>(), start<Real>); });
        row("tether in space", name,
            [&]<class Real>(Hash& h) { add_run(h, method, Tether<Real>(Real(2.9), Real(0.6)), start_in_space<Real>); });
    }
    if constexpr (Method::takes_damping) {
        row("damped spring", name,
            [&]<class Real>(Hash& h) { add_run(h, method, DampedSpring<Real>(Real(3.1), Real(0.07)), start<Real>); });
        if constexpr (!std::is_same_v<Method, SemiImplicitEulerNewDamping>)
            row("drag in space", name,
                [&]<class Real>(Hash& h) { add_run(h, method, Drag<Real>(Real(0.13)), start_in_space<Real>); });
    }
}

template <class Method>
void print_systems(const Method& method) {
    const char* name = Method::name;
    row("complex decay", name, [&]<class Real>(Hash& h) {
        using V2 = Eigen::Matrix<Real, 2, 1>;
        const ComplexDecay<Real> decay({Real(-0.03), Real(2.3)});
        add_run(h, method, decay, FirstOrder<V2>{0, V2(Real(1.1), Real(0.3))});
    });
    row("van der Pol", name, [&]<class Real>(Hash& h) {
        using V2 = Eigen::Matrix<Real, 2, 1>;
        add_run(h, method, VanDerPol<Real>(Real(5.3)), FirstOrder<V2>{0, V2(Real(1.9), Real(0.1))});
    });
    row("Robertson", name, [&]<class Real>(Hash& h) {
        add_run(h, method, Robertson<Real>(), FirstOrder<Vector3<Real>>{0, Vector3<Real>(1, 0, 0)}, 0.0003);
    });
}

inline void print_rows() {
    for_each_method([](const auto& method) {
        print_forces(method);
        if constexpr (!std::is_same_v<std::decay_t<decltype(method)>, SemiImplicitEuler>) print_systems(method);
    });
    print_forces(semi_implicit_euler_new_damping);
    for_each_verlet_method([](const auto& method) { print_forces(method); });
}

}  // namespace forces
