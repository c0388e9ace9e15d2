#pragma once
// SPDX-License-Identifier: MIT
/// \file
/// Cube root, sine and cosine, the same bits on every machine. For C99 and C++; the library's
/// headers use them by own_math.hpp.
///
/// IEEE arithmetic rounds +, −, ×, ÷ and √ in one way only. The roundings of sin, cos and cbrt
/// depend on the mathematical library, and on the compiler if it knows the argument. So steps that
/// rotate a body use these functions. From <math.h> they use only what is exact: frexp, ldexp and
/// fmod.

#include <math.h>

/// \cond
#if defined(__cplusplus)
#define TIMESTEP_C_TO(type, value) static_cast<type>(value)
#else
#define TIMESTEP_C_TO(type, value) ((type)(value))
#endif
/// \endcond

/// ∛x, off by at most a roundoff.
static inline double timestep_cbrt(double x) {
    double y = 1, m;
    int e = 0, k, i;
    if (x == 0 || x - x != 0) return x;  // zero, infinite, or no number
    m = frexp(fabs(x), &e);              // ½ to 1, times 2^e
    k = e / 3;
    for (e -= 3 * k; e > 0; --e) m *= 2;
    for (; e < 0; ++e) m /= 2;  // 1/8 to 4, of which the root is ½ to 1.6
    // Newton's iterations, y ← y − (y³ − m)/(3y²): from 1 the fourth is off by 2e-4 at the most,
    // and each that follows squares that.
    for (i = 0; i < 7; ++i) y -= (y * y * y - m) / (3 * y * y);
    return ldexp(x < 0 ? -y : y, k);
}
/// ∛x in `float`.
static inline float timestep_cbrtf(float x) {
    return TIMESTEP_C_TO(float, timestep_cbrt(TIMESTEP_C_TO(double, x)));
}

/// \cond
#if defined(__GNUC__)
#define TIMESTEP_C_HERE static inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define TIMESTEP_C_HERE static __forceinline
#else
#define TIMESTEP_C_HERE static inline
#endif

// What is left of x without `quarters` quarter turns. π/2 is taken in three parts: the first two
// have 33 bits each, so that so many times they are exact.
static inline double timestep_without_quarters(double x, int* quarters) {
    double n;
    if (!(fabs(x) <= 500000))
        x = fmod(x, 6.283185307179586);  // exact, but for what this number is off 2π
    *quarters = 0;
    if (x != x) return x;
    *quarters = TIMESTEP_C_TO(int, x * 0.6366197723675814 + (x < 0 ? -0.5 : 0.5));
    n = *quarters;
    return x - n * 1.5707963267341256 - n * 6.077100506303966e-11 - n * 2.0222662487959506e-21;
}
/// \endcond

/// sin x and cos x, off by at most a roundoff of 1; for angles beyond half a million, by a roundoff
/// of the angle. NaN for infinity and NaN.
TIMESTEP_C_HERE void timestep_sine_cosine(double x, double* sine, double* cosine) {
    int quarters = 0;
    const double r = fabs(x) <= 0.7853981633974483 ? x : timestep_without_quarters(x, &quarters);
    const double z = r * r, zz = z * z, zzzz = zz * zz;
    // Taylor's series, to the last term that is half a roundoff at π/4; in pairs, of which the
    // processor takes several at a time.
    const double s =
        r + r * z *
                (-1.0 / 6 + z * (1.0 / 120) + zz * (-1.0 / 5040 + z * (1.0 / 362880)) +
                 zzzz * (-1.0 / 39916800 + z * (1.0 / 6227020800) + zz * (-1.0 / 1307674368000)));
    const double c =
        1 - z / 2 +
        zz * (1.0 / 24 + z * (-1.0 / 720) + zz * (1.0 / 40320 + z * (-1.0 / 3628800)) +
              zzzz * (1.0 / 479001600 + z * (-1.0 / 87178291200) + zz * (1.0 / 20922789888000)));
    *sine = quarters & 1 ? c : s, *cosine = quarters & 1 ? s : c;
    if (quarters & 2) *sine = -*sine;
    if ((quarters + 1) & 2) *cosine = -*cosine;
}
/// sin x and cos x in `float`: computed in `double` and rounded.
TIMESTEP_C_HERE void timestep_sine_cosinef(float x, float* sine, float* cosine) {
    int quarters = 0;
    const double r = fabsf(x) <= 0.785398f
                         ? TIMESTEP_C_TO(double, x)
                         : timestep_without_quarters(TIMESTEP_C_TO(double, x), &quarters);
    const double z = r * r, zz = z * z;
    // Shorter, and as near for float: polynomials through the functions at the zeros of a Chebyshev
    // polynomial.
    const float s = TIMESTEP_C_TO(
        float, r + r * z * (-0.1666666466 + z * 0.008332747688 + zz * -0.0001958776499));
    const float c = TIMESTEP_C_TO(float, 1 + z * (-0.4999999997 + z * 0.04166665062 +
                                                  zz * (-0.001388758786 + z * 2.446362048e-05)));
    *sine = quarters & 1 ? c : s, *cosine = quarters & 1 ? s : c;
    if (quarters & 2) *sine = -*sine;
    if ((quarters + 1) & 2) *cosine = -*cosine;
}
