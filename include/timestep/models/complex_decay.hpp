#pragma once
/// \file
/// Decay at a complex rate: the part of which every linear motion is a sum.

#include <cmath>
#include <complex>

#include <timestep/checks.hpp>
#include <timestep/linear_solve.hpp>

namespace timestep {

/// ẏ = λ y with λ = a + ib, which turns by b a second while it decays by −a. The complex number
/// y = p + iq is held as the vector (p, q), so that real methods step it:
///     ṗ = a p − b q,    q̇ = b p + a q.
/// A damped oscillation is one such motion and its mirror image, with λ = ω (−ζ ± i √(1 − ζ²)).
template <class Real>
struct ComplexDecay {
    std::complex<Real> lambda;  ///< relative rate, 1/s

    /// `lambda` in 1/s, both parts finite. Throws `std::invalid_argument`.
    explicit ComplexDecay(const std::complex<Real>& lambda_)
        : lambda(finite("real part of lambda", lambda_.real()),
                 finite("imaginary part of lambda", lambda_.imag())) {}

    /// f(t, y) = λ y, for a vector of two numbers.
    template <class Y>
    Y operator()(real_of<Y> /* t */, const Y& y) const {
        const Real a = lambda.real(), b = lambda.imag();
        return Y(a * y[0] - b * y[1], b * y[0] + a * y[1]);
    }

    /// ∂f/∂y, 1/s: the matrix with rows (a, −b) and (b, a).
    template <class Y>
    auto slope_y(real_of<Y> /* t */, const Y& y) const {
        auto slope = outer(y, y);  // for its type
        slope << lambda.real(), -lambda.imag(), lambda.imag(), lambda.real();
        return slope;
    }

    /// The exact state `t` seconds after `start`: e^(λt) y₀.
    template <class Y>
    FirstOrder<Y> exact(const FirstOrder<Y>& start, real_of<Y> t) const {
        const std::complex<Real> y =
            std::exp(lambda * t) * std::complex<Real>(start.y[0], start.y[1]);
        return {start.t + t, Y(y.real(), y.imag())};
    }
};

}  // namespace timestep
