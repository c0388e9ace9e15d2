#pragma once
// Forces: the methods for State, of numbers and of vectors. Starts and parameters have no short binary fraction.
#include <type_traits>

#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/models/tether.hpp>
#include <timestep/run.hpp>

#include "hash.hpp"

namespace points {

// A spring that stiffens, a = −x − x³: implicit methods need Newton–Raphson.
template <class Real>
struct StiffeningSpring {
    Real acceleration(Real x) const { return -x - x * x * x; }
    Real slope_x(Real x, Real) const { return -1 - 3 * x * x; }
    Real slope_v(Real, Real) const { return 0; }
};

template <class Model, class X, class Method>
void print(const char* scene, const Method& method, const Model& model, const State<X>& start) {
    Hash hash;
    run(method, model, start, real_of<X>(0.0173), bits_steps, [&](const auto& s) { hash.add(s); });
    row(hash, name_of<real_of<X>>, scene, Method::name);
}

template <class Method>
inline constexpr bool for_position_forces =
    std::is_same_v<Method, Verlet> || std::is_same_v<Method, VelocityVerlet> || std::is_same_v<Method, Leapfrog>;

template <class Real, class Method>
void print_all(const Method& method) {
    const State<Real> start{0, Real(1.1), Real(-0.3)};
    using V2 = Eigen::Matrix<Real, 2, 1>;
    using V3 = Eigen::Matrix<Real, 3, 1>;
    using V4 = Eigen::Matrix<Real, 4, 1>;
    using V5 = Eigen::Matrix<Real, 5, 1>;
    const State<V2> flat{0, V2(Real(1.1), Real(0.7)), V2(Real(0.2), Real(-0.9))};
    const State<V3> space{0, V3(Real(1.1), Real(0.7), Real(-0.6)), V3(Real(0.2), Real(-0.9), Real(3.1))};
    const State<V4> row_of_four{0, V4(Real(0.1), Real(-0.2), Real(0.3), Real(0.7)), V4::Zero()};
    V5 stiff;
    stiff << Real(10.1), Real(20.3), Real(7.7), Real(0), Real(3.3);
    print("spring", method, Spring<Real>(Real(3.1)), start);
    print("spring in space", method, Spring<Real>(Real(3.1)), space);
    print("projectile", method, Projectile<V3>(V3(0, 0, Real(-9.81))), space);
    print("coupled springs", method, CoupledSprings(V4(Real(1.1), Real(0.7), Real(2.3), Real(0.9)), stiff),
          row_of_four);
    if constexpr (!std::is_same_v<Method, SemiImplicitEulerNewDamping>) {
        print("stiffening spring", method, StiffeningSpring<Real>(), start);
        print("tether", method, Tether<Real>(Real(2.9), Real(0.6)), flat);
        print("tether in space", method, Tether<Real>(Real(2.9), Real(0.6)), space);
        print("pendulum (not promised)", method, Pendulum<Real>(Real(2.9)), start);  // libm's sine
    }
    if constexpr (!for_position_forces<Method>) {
        print("damped spring", method, DampedSpring<Real>(Real(3.1), Real(0.07)), start);
        if constexpr (!std::is_same_v<Method, SemiImplicitEulerNewDamping>)
            print("drag in space", method, Drag<Real>(Real(0.13)), space);
    }
}

template <class Method>
void print_all(const Method& method) {
    print_all<float>(method);
    print_all<double>(method);
}

inline void print_rows() {
    for_each_method([](const auto& method) { print_all(method); });
    print_all(semi_implicit_euler_new_damping);
    for_each_verlet_method([](const auto& method) { print_all(method); });
}

}  // namespace points
