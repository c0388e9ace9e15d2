#pragma once
/// \file
/// How far off a slope from differences may be, and the step that makes the best of it (N01, N08).

#include <cmath>

#include <timestep/differences.hpp>

namespace timestep {

/// The most that `formula` can be off at step `h`, when each value of f is off by up to `noise` and
/// `slope` bounds |f⁽ᵖ⁺¹⁾| over the points used (p is the formula's order).
///
/// Noise is whatever rounds the values: the last digit of a float, the grid of a compressed
/// animation, the jitter of a tracker.
/// [bound]
template <class Formula>
double error_bound(const Formula& formula, double h, double noise, double slope) {
    const double truncation = formula.error_constant * std::pow(h, formula.order) * slope;
    return truncation + formula.noise_gain * noise / h;
}
/// [bound]

/// The step at which `error_bound` is smallest. Its two parts are A hᵖ and B/h; the derivative
/// p A hᵖ⁻¹ − B/h² vanishes at hᵖ⁺¹ = B/(p A). Infinite where `slope` is zero.
/// [best_step]
template <class Formula>
double best_step(const Formula& formula, double noise, double slope) {
    const double a = formula.error_constant * slope;
    const double b = formula.noise_gain * noise;
    return std::pow(b / (formula.order * a), 1.0 / (formula.order + 1));
}
/// [best_step]

}  // namespace timestep
