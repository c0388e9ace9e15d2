#pragma once
// Any force or system behind one type: a solver is compiled once for all scenes that it is tested with,
// instead of once for each.

#include <functional>

#include <timestep/forces.hpp>

namespace test_support {

// The acceleration of any force at x and v.
template <class X>
struct AnyForce {
    std::function<X(const X&, const X&)> call;

    template <class Model>
    explicit AnyForce(const Model& model)
        : call([model](const X& x, const X& v) { return timestep::acceleration(model, x, v); }) {}
    X acceleration(const X& x, const X& v) const { return call(x, v); }
};

// The rate of change f(t, y) of any first-order system.
template <class Y>
using AnySystem = std::function<Y(timestep::real_of<Y>, const Y&)>;

}  // namespace test_support
