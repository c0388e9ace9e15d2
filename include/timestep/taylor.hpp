#pragma once
/// \file
/// Taylor series: a function a step away, from its derivatives at one point (N09, N10).

#include <concepts>
#include <cstddef>
#include <span>

namespace timestep {

/// The Taylor series f + h f′ + h²/2 f″ + …, as many terms as `derivatives` has: f itself first,
/// then f′, f″ and so on, all at one point. Zero terms give zero.
///
/// After the term in hⁿ the series is off by h⁽ⁿ⁺¹⁾/(n+1)! times the next derivative at some point
/// in between.
///
/// The sum starts at the far end, f + h (f′ + h/2 (f″ + …)), so no power of h stands alone and
/// overflows while its term does not.
template <std::floating_point Real, std::size_t Extent>
Real taylor(std::span<const Real, Extent> derivatives, Real h) {
    Real sum = 0;
    for (std::size_t k = derivatives.size(); k-- > 0;)
        sum = derivatives[k] + h / static_cast<Real>(k + 1) * sum;
    return sum;
}

}  // namespace timestep
