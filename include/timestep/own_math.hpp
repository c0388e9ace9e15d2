#pragma once
/// \file
/// Cube root, sine and cosine, the same bits on every machine: own_math.h for templates.

#include <cmath>

#include <timestep/own_math.h>

namespace timestep {

/// The result of sine_cosine().
template <class Real>
struct SineCosine {
    Real sine;    ///< sin x
    Real cosine;  ///< cos x
};

/// sin x and cos x.
inline SineCosine<double> sine_cosine(double x) {
    SineCosine<double> of;
    timestep_sine_cosine(x, &of.sine, &of.cosine);
    return of;
}
/// sin x and cos x in `float`.
inline SineCosine<float> sine_cosine(float x) {
    SineCosine<float> of;
    timestep_sine_cosinef(x, &of.sine, &of.cosine);
    return of;
}
/// sin x and cos x of other number types, by their own functions. (`long double` differs from
/// machine to machine anyway.)
template <class Real>
SineCosine<Real> sine_cosine(const Real& x) {
    using std::cos, std::sin;
    return {sin(x), cos(x)};
}

/// ∛x.
inline double cube_root(double x) { return timestep_cbrt(x); }
/// ∛x in `float`.
inline float cube_root(float x) { return timestep_cbrtf(x); }
/// ∛x of other number types, by their own function.
template <class Real>
Real cube_root(const Real& x) {
    using std::cbrt;
    return cbrt(x);
}

}  // namespace timestep
