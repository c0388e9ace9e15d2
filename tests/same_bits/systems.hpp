#pragma once
// First-order systems.
#include <timestep/methods.hpp>
#include <timestep/models/complex_decay.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/prothero_robinson.hpp>
#include <timestep/models/robertson.hpp>
#include <timestep/models/van_der_pol.hpp>
#include <timestep/run.hpp>

#include "hash.hpp"

namespace systems {

// ẏ = −y³.
template <class Real>
struct Cooling {
    Real operator()(Real, Real y) const { return -y * y * y; }
    Real slope_y(Real, Real y) const { return -3 * y * y; }
};

template <class Method, class System, class Y>
void print(const char* scene, const Method& method, const System& f, const FirstOrder<Y>& start, double h) {
    const auto step = real_of<Y>(h);
    if constexpr (
        requires { method.step(f, start, step); } || requires { method.step(f, start, start, step); }) {
        Hash hash;
        run(method, f, start, step, bits_steps, [&](const auto& s) { hash.add(s); });
        row(hash, name_of<real_of<Y>>, scene, Method::name);
    }
}

template <class Real, class Method>
void print_all(const Method& method) {
    const FirstOrder<Real> warm{0, Real(1.1)};
    print("cooling", method, Cooling<Real>(), warm, 0.0173);
    print("decay", method, Decay<Real>(Real(-0.37)), warm, 0.0173);
    print("Prothero (not promised)", method, ProtheroRobinson<Real>(Real(-1.9)), warm, 0.0173);  // libm's cosine
    using V2 = Eigen::Matrix<Real, 2, 1>;
    print("complex decay", method, ComplexDecay<Real>({Real(-0.03), Real(2.3)}),
          FirstOrder<V2>{0, V2(Real(1.1), Real(0.3))}, 0.0173);
    print("van der Pol", method, VanDerPol<Real>(Real(5.3)), FirstOrder<V2>{0, V2(Real(1.9), Real(0.1))}, 0.0173);
    using V3 = Eigen::Matrix<Real, 3, 1>;
    print("Robertson", method, Robertson<Real>(), FirstOrder<V3>{0, V3(1, 0, 0)}, 0.0003);
}

inline void print_rows() {
    const auto both = [](const auto& method) {
        print_all<float>(method);
        print_all<double>(method);
    };
    for_each_method(both);
    for_each_verlet_method(both);
}

}  // namespace systems
