#pragma once
/// \file
/// Finite differences: the slope of a function from a few of its values (N01, N07, N08).
///
/// Each formula is a small function object: `central_difference(f, x, h)` is the slope of `f` at
/// `x`. `f` is anything that can be called with a real number; it may return a number or a
/// fixed-size Eigen vector. Units: those of `f` over those of `x`.
///
/// A slope from differences has two errors. Truncation is what the formula leaves out of the Taylor
/// series, `error_constant` · hᵖ · |f⁽ᵖ⁺¹⁾| with p = `order`. Noise is what the values carry:
/// when each is off by up to δ, the slope is off by up to `noise_gain` · δ/h.

#include <concepts>
#include <type_traits>

namespace timestep {

/// The value that a function `F` returns for a real number: a number or a vector.
template <class F, class Real>
using value_of = std::decay_t<std::invoke_result_t<const F&, Real>>;

/// The value after minus the value now, over the step (N07).
struct ForwardDifference {
    static constexpr const char* name = "forward";  ///< for tables and keys
    static constexpr int order = 1;                 ///< p: truncation goes with hᵖ
    static constexpr int evaluations = 2;           ///< values of `f` for one slope
    static constexpr double error_constant = 1.0 / 2;  ///< truncation is this times hᵖ f⁽ᵖ⁺¹⁾
    static constexpr double noise_gain = 2;            ///< noise δ gives this times δ/h

    /// The slope of `f` at `x` with step `h`.
    template <class F, std::floating_point Real>
    value_of<F, Real> operator()(const F& f, Real x, Real h) const {
        return (f(x + h) - f(x)) / h;
    }
};

/// The value now minus the value before, over the step: the forward difference with −h (N07).
struct BackwardDifference {
    static constexpr const char* name = "backward";  ///< for tables and keys
    static constexpr int order = 1;                  ///< p: truncation goes with hᵖ
    static constexpr int evaluations = 2;            ///< values of `f` for one slope
    static constexpr double error_constant = 1.0 / 2;  ///< truncation is this times hᵖ f⁽ᵖ⁺¹⁾
    static constexpr double noise_gain = 2;            ///< noise δ gives this times δ/h

    /// The slope of `f` at `x` with step `h`.
    template <class F, std::floating_point Real>
    value_of<F, Real> operator()(const F& f, Real x, Real h) const {
        return (f(x) - f(x - h)) / h;
    }
};

/// One step to either side (N08). Subtracting the Taylor series for f(x − h) from that for
/// f(x + h) removes the second derivative.
struct CentralDifference {
    static constexpr const char* name = "central";  ///< for tables and keys
    static constexpr int order = 2;                 ///< p: truncation goes with hᵖ
    static constexpr int evaluations = 2;           ///< values of `f` for one slope
    static constexpr double error_constant = 1.0 / 6;  ///< truncation is this times hᵖ f⁽ᵖ⁺¹⁾
    static constexpr double noise_gain = 1;            ///< noise δ gives this times δ/h

    /// The slope of `f` at `x` with step `h`.
    /// [central]
    template <class F, std::floating_point Real>
    value_of<F, Real> operator()(const F& f, Real x, Real h) const {
        return (f(x + h) - f(x - h)) / (2 * h);
    }
    /// [central]
};

/// Two steps to either side (N08). A central difference over 2h errs four times as much as one
/// over h, so four thirds of the narrow one less a third of the wide one removes the third
/// derivative too (Richardson extrapolation). The fifth point is `x` itself, with weight zero.
struct FivePointDifference {
    static constexpr const char* name = "five-point";  ///< for tables and keys
    static constexpr int order = 4;                    ///< p: truncation goes with hᵖ
    static constexpr int evaluations = 4;              ///< values of `f` for one slope
    static constexpr double error_constant = 1.0 / 30;  ///< truncation is this times hᵖ f⁽ᵖ⁺¹⁾
    static constexpr double noise_gain = 18.0 / 12;  ///< noise δ gives this times δ/h

    /// The slope of `f` at `x` with step `h`.
    template <class F, std::floating_point Real>
    value_of<F, Real> operator()(const F& f, Real x, Real h) const {
        const value_of<F, Real> narrow = f(x + h) - f(x - h);
        const value_of<F, Real> wide = f(x + 2 * h) - f(x - 2 * h);
        // four thirds of narrow/(2h) less one third of wide/(4h)
        return (8 * narrow - wide) / (12 * h);
    }
};

inline constexpr ForwardDifference forward_difference;       ///< the formula as a value
inline constexpr BackwardDifference backward_difference;     ///< the formula as a value
inline constexpr CentralDifference central_difference;       ///< the formula as a value
inline constexpr FivePointDifference five_point_difference;  ///< the formula as a value

/// The step that is taken after rounding: `x + h` is rounded to a `Real`, and this is its distance
/// from `x`. Zero if `h` is too small to change `x`.
/// [step_taken]
template <std::floating_point Real>
Real step_taken(Real x, Real h) {
    const Real next = x + h;
    return next - x;
}
/// [step_taken]

}  // namespace timestep
