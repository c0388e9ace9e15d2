#pragma once
/// \file
/// Newton–Raphson: find the root of a smooth function by following its tangent.

#include <algorithm>
#include <limits>

#include <timestep/linear_solve.hpp>

namespace timestep {

/// Solves f(x) = 0 for a number or a vector, starting from `x` (N26, N48).
///
/// The tangent at x is f(x) + J(x) (x₂ − x); its root is the next x. Near a simple root the number of
/// right digits doubles each time. Far from it, where the function bends, Newton–Raphson may jump
/// about for ever: after 50 corrections it gives up, and the x it returns is no root.
///
/// It stops when a correction is some ε times the largest size that x has had on the way: near a root
/// at zero, x itself would be no measure. It is meant for starts of about the size of the root, as a
/// time step gives them. Where f is made of large terms that cancel, as at rest on a stiff spring,
/// corrections stop shrinking sooner, at the roundoff of those terms: so a small one that is more than
/// half of the last one ends it, too.
/// [newton]
template <class X, class Function, class Jacobian>
X newton_raphson(X x, const Function& f, const Jacobian& jacobian) {
    const real_of<X> digits = 4 * std::numeric_limits<real_of<X>>::epsilon();
    real_of<X> largest = magnitude(x), before = 0;
    for (int i = 0; i < 50; ++i) {
        const X correction = solve(jacobian(x), f(x));
        x -= correction;
        const real_of<X> size = magnitude(correction);
        if (!(size > digits * largest)) break;  // also when it is a NaN
        if (size > before / 2 && size < largest / 1000 && i > 0) break;
        before = size;
        largest = std::max(largest, magnitude(x));
    }
    return x;
}
/// [newton]

}  // namespace timestep
