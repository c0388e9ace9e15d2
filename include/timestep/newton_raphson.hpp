#pragma once
/// \file
/// Newton–Raphson: find the root of a smooth function by following its tangent.

#include <algorithm>
#include <cmath>
#include <limits>

#include <timestep/checks.hpp>
#include <timestep/linear_solve.hpp>

namespace timestep {

/// The result of Newton–Raphson. `x` is a root only if `found` is true.
template <class X>
struct Root {
    X x;         ///< the root; if none was found, the point on the way where |f| was least
    bool found;  ///< whether x is a root
};

/// Solves f(x) = 0 for a number or a vector, starting from `x` (N26, N48).
///
/// The tangent at x is f(x) + J(x) (x₂ − x); its root is the next x. Near a simple root the number
/// of right digits doubles each time. Far from it, where the function bends, the tangent's root may
/// be worse than x itself; then half of the correction is tried, and half again, until |f(x)|
/// shrinks. So a function that rises everywhere is solved from anywhere, if 50 corrections suffice.
/// The iteration ends after 50, or at a point where |f| is least and not zero: there the full
/// correction is still long, and the point is no root. x is NaN if the tangent is too steep for
/// numbers, or if f(x) or the correction is too large.
///
/// It stops when a correction is a few ε times the largest size that x has had on the way: near a
/// root at zero, x itself would be no measure. It is meant for starts of about the size of the
/// root, as in a time step. If f is a sum of large terms that cancel, as at rest on a stiff spring,
/// f stops shrinking sooner, at the roundoff of those terms. There halving ends the iteration, or
/// the iterates alternate until 50 corrections are used up. The latter happens for a pendulum after
/// a hundred turns, whose angle has far more roundoff than its velocity. Either end counts as a
/// root if the last full correction was short: at most √ε of that largest size. Near a simple root
/// of a smooth f the next correction would be about the square of this one, some ε, and the loop
/// would have ended: what is left is roundoff. A least |f| that is as near to zero as that counts
/// as a root, too.
template <class X, class Function, class Jacobian>
[[nodiscard]] Root<X> newton_raphson(X x, const Function& f, const Jacobian& jacobian) {
    const real_of<X> epsilon = std::numeric_limits<real_of<X>>::epsilon(), digits = 4 * epsilon;
    real_of<X> largest = safe_magnitude(x);
    X residual = f(x);
    bool short_way = false;
    for (int i = 0; i < 50; ++i) {
        const auto& tangent = jacobian(x);
        X correction = solve(tangent, residual);
        real_of<X> size = safe_magnitude(correction);
        if (!is_finite(tangent) || !is_finite(size + largest))
            return {X(std::numeric_limits<real_of<X>>::quiet_NaN() * x), false};
        short_way = size <= std::sqrt(epsilon) * largest;
        X next = x - correction;
        X left = residual;
        while (size > digits * largest) {
            left = f(next);
            if (safe_magnitude(left) < safe_magnitude(residual)) break;
            correction /= 2;
            size /= 2;
            next = x - correction;
        }
        if (size <= digits * largest) return {next, short_way};
        x = next;
        residual = left;
        largest = std::max(largest, safe_magnitude(x));
    }
    return {x, short_way};
}

}  // namespace timestep
