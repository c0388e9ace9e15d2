#pragma once
/// \file
/// Exponential growth and decay, the simplest equation whose rate depends on its unknown.

#include <cmath>

#include <timestep/checks.hpp>

namespace timestep {

/// ẏ = λ y: the rate is proportional to y (N11). λ < 0 is decay, such as the glow of an
/// ember or a sound that fades; λ > 0 is growth. A first-order system: y is a number or a vector.
template <class Real>
struct Decay {
    Real lambda;  ///< relative rate, 1/s

    /// `lambda` in 1/s, any finite number. Throws `std::invalid_argument`.
    explicit Decay(Real lambda_) : lambda(finite("lambda", lambda_)) {}

    /// f(t, y) = λ y.
    template <class Y>
    Y operator()(real_of<Y> /* t */, const Y& y) const {
        return lambda * y;
    }

    /// ∂f/∂y = λ, 1/s.
    template <class Y>
    Real slope_y(real_of<Y> /* t */, const Y& /* y */) const {
        return lambda;
    }

    /// The exact state `t` seconds after `start`: y₀ e^(λt).
    template <class Y>
    FirstOrder<Y> exact(const FirstOrder<Y>& start, real_of<Y> t) const {
        using std::exp;
        const real_of<Y> growth = exp(lambda * t);
        return {start.t + t, growth * start.y};
    }
};

}  // namespace timestep
