#pragma once
/// \file
/// Newton–Raphson: find the root of a smooth function by following its tangent.

#include <limits>

#include <timestep/linear_solve.hpp>

namespace timestep {

/// Solves f(x) = 0 for a number or a vector, starting from `x` (N26, N48).
///
/// The tangent at x is f(x) + J(x) (x₂ − x); its root is the next x. Near the root the number of
/// right digits doubles each time. Stops when a correction no longer changes the digits of x, at
/// the latest after 50 corrections: then the last x is returned, and may not be a root.
template <class X, class Function, class Jacobian>
X newton_raphson(X x, const Function& f, const Jacobian& jacobian) {
    const real_of<X> digits = 4 * std::numeric_limits<real_of<X>>::epsilon();
    for (int i = 0; i < 50; ++i) {
        const X correction = solve(jacobian(x), f(x));
        x -= correction;
        if (!(magnitude(correction) > digits * magnitude(x))) break;  // also when it is a NaN
    }
    return x;
}

}  // namespace timestep
