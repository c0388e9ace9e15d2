#pragma once
/// \file
/// The error bound of a slope from differences, and the step that minimises it (N01, N08).

#include <cmath>

#include <timestep/differences.hpp>

namespace timestep {

/// The largest error of `formula` at step `h`, if each value of f is off by up to `noise` and
/// `next` bounds the next derivative |f⁽ᵖ⁺¹⁾| over the points used (p is the formula's order).
///
/// Noise is whatever rounds the values: the last digit of a float, the grid of a compressed
/// animation, the jitter of a tracker.
/// [bound]
template <class Formula>
double error_bound(const Formula&, double h, double noise, double next) {
    const double c = Formula::error_constant * next;
    const double truncation = c * std::pow(h, Formula::order);
    return truncation + Formula::noise_gain * noise / h;
}
/// [bound]

/// The step at which `error_bound` is smallest. Its two parts are C hᵖ and G δ/h; the derivative
/// p C hᵖ⁻¹ − G δ/h² vanishes at hᵖ⁺¹ = G δ/(p C). Infinite where `next` is zero and
/// the noise is not.
/// [best_step]
template <class Formula>
double best_step(const Formula&, double noise, double next) {
    const double c = Formula::error_constant * next;
    const double g = Formula::noise_gain * noise;
    return std::pow(g / (Formula::order * c), 1.0 / (Formula::order + 1));
}
/// [best_step]

}  // namespace timestep
