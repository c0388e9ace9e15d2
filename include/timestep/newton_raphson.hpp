#pragma once
/// \file
/// Newton–Raphson: find the root of a smooth function by following its tangent.

#include <algorithm>
#include <limits>

#include <timestep/linear_solve.hpp>

namespace timestep {

/// Solves f(x) = 0 for a number or a vector, starting from `x` (N26, N48).
///
/// The tangent at x is f(x) + J(x) (x₂ − x); its root is the next x. Near the root the number of
/// right digits doubles each time. Far from it, where the function bends, Newton–Raphson may jump
/// about for ever: after 50 corrections it gives up, and the x it returns is no root.
///
/// It stops when a correction is down to the roundoff of f, some ε times the largest size that x
/// has had on the way: near a root at zero, x itself would be no measure.
/// [newton]
template <class X, class Function, class Jacobian>
X newton_raphson(X x, const Function& f, const Jacobian& jacobian) {
    const real_of<X> digits = 4 * std::numeric_limits<real_of<X>>::epsilon();
    real_of<X> largest = magnitude(x);
    for (int i = 0; i < 50; ++i) {
        const X correction = solve(jacobian(x), f(x));
        x -= correction;
        if (!(magnitude(correction) > digits * largest)) break;  // also when it is a NaN
        largest = std::max(largest, magnitude(x));
    }
    return x;
}
/// [newton]

}  // namespace timestep
