#pragma once
/// \file
/// Jacobi's elliptic functions and Carlson's elliptic integrals, from which the motion of a
/// tumbling body is built.

#include <algorithm>
#include <cmath>
#include <limits>

namespace timestep {

/// The values of Jacobi's elliptic functions.
template <class Real>
struct Elliptic {
    Real sn;  ///< a sine with flat extremes; tanh u in the limit m₁ → 0
    Real cn;  ///< the matching cosine; sech u in the limit
    Real dn;  ///< √(1 − m sn²), between √m₁ and 1; sech u in the limit
};

/// sn, cn and dn at `u` for the parameter m = 1 − m₁, 0 ≤ m₁ ≤ 1. Taking m₁ keeps the digits near
/// the separatrix, where m is 1 and the period infinite; cn and dn are right to their own last
/// digits there, however small they are.
///
/// Gauss' transformation, round by round, takes k = √m to k₁ = (1 − √m₁)/(1 + √m₁), which is soon
/// zero: then sn is a sine. On the way back, with c = cn/sn,
///     c = c₁ dn₁/(1 + k₁),    dn = (1 − k₁ sn₁²)/(1 + k₁ sn₁²) = (1 − k₁ + c₁²)/(1 + k₁ + c₁²).
template <class Real>
Elliptic<Real> jacobi(Real u, Real m1) {
    using std::cos, std::cosh, std::sin, std::sqrt, std::tanh;
    if (m1 == 0) return {tanh(u), 1 / cosh(u), 1 / cosh(u)};
    Real a = 1, b = sqrt(m1);
    Real k[32], rest[32];  // k₁ of each round, and 1 − k₁
    int rounds = 0;
    while (a - b > std::numeric_limits<Real>::epsilon() * a && rounds < 32) {
        k[rounds] = (a - b) / (a + b);
        rest[rounds++] = 2 * b / (a + b);
        const Real mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
    }
    const Real sine = sin(a * u), cosine = cos(a * u);
    // So small that c² would overflow, and no digit of dn differ from 1.
    if (sine * sine < std::numeric_limits<Real>::min()) return {sine / a, cosine, Real(1)};
    Real c = cosine / sine, dn = 1;
    while (rounds-- > 0) {
        const Real c1 = c;
        c = c1 * dn / (1 + k[rounds]);
        dn = (rest[rounds] + c1 * c1) / (1 + k[rounds] + c1 * c1);
    }
    const Real sn = std::copysign(1 / sqrt(1 + c * c), sine);
    return {sn, c * sn, dn};
}

// Carlson's integrals are symmetric in x, y and z, and do not change when each of them goes to a
// quarter of its sum with λ. The three close in on each other four times a round; when they agree
// so well that the square of what is left is roundoff, the integrand is a power of their mean.

/// R_F = ½ ∫₀^∞ dt / √((t + x)(t + y)(t + z)); at most one of the three may be zero.
template <class Real>
Real carlson_rf(Real x, Real y, Real z) {
    using std::abs, std::max, std::sqrt;
    for (;;) {
        const Real mean = (x + y + z) / 3;
        const Real spread = max({abs(x - mean), abs(y - mean), abs(z - mean)}) / mean;
        if (!(spread * spread > std::numeric_limits<Real>::epsilon())) return 1 / sqrt(mean);
        const Real lambda = sqrt(x) * sqrt(y) + sqrt(y) * sqrt(z) + sqrt(z) * sqrt(x);
        x = (x + lambda) / 4, y = (y + lambda) / 4, z = (z + lambda) / 4;
    }
}

/// R_J = 3/2 ∫₀^∞ dt / ((t + p) √((t + x)(t + y)(t + z))), p > 0. Each round leaves a simpler
/// integral behind, which is added up (Carlson 1995, Numerical Algorithms 10, 13–26).
template <class Real>
Real carlson_rj(Real x, Real y, Real z, Real p) {
    using std::abs, std::max, std::sqrt;
    const Real delta = (p - x) * (p - y) * (p - z);
    Real sum = 0, quarter = 1;  // quarter: 4⁻ⁿ
    for (;;) {
        const Real mean = (x + y + z + 2 * p) / 5;
        const Real spread =
            max({abs(x - mean), abs(y - mean), abs(z - mean), abs(p - mean)}) / mean;
        if (!(spread * spread > std::numeric_limits<Real>::epsilon()))
            return quarter / (mean * sqrt(mean)) + 6 * sum;
        const Real lambda = sqrt(x) * sqrt(y) + sqrt(y) * sqrt(z) + sqrt(z) * sqrt(x);
        const Real d = (sqrt(p) + sqrt(x)) * (sqrt(p) + sqrt(y)) * (sqrt(p) + sqrt(z));
        const Real e = quarter * quarter * quarter * delta / (d * d);
        sum += quarter / d * carlson_rf(Real(1), 1 + e, 1 + e);
        x = (x + lambda) / 4, y = (y + lambda) / 4, z = (z + lambda) / 4, p = (p + lambda) / 4;
        quarter /= 4;
    }
}

}  // namespace timestep
