#pragma once
/// \file
/// A slow motion with a fast pull towards it.

#include <cmath>

#include <timestep/checks.hpp>

namespace timestep {

/// Prothero and Robinson's problem ẏ = λ(y − cos t) − sin t (Math. Comp. 28, 1974). Its solution
/// from y(0) = 1 is cos t for every λ, and for λ far below zero other solutions are pulled there at
/// once. So a method's error shows how it treats the pull.
template <class Real>
struct ProtheroRobinson {
    Real lambda;  ///< rate of the pull, 1/s

    /// `lambda` in 1/s, any finite number. Throws `std::invalid_argument`.
    explicit ProtheroRobinson(Real lambda_) : lambda(finite("lambda", lambda_)) {}

    /// The rate λ(y − cos t) − sin t.
    Real operator()(Real t, Real y) const { return lambda * (y - std::cos(t)) - std::sin(t); }

    /// ∂f/∂y = λ, 1/s.
    Real slope_y(Real /* t */, Real /* y */) const { return lambda; }

    /// The exact state `t` seconds after `start`: cos t, plus the distance from it at the
    /// start times e^(λt).
    FirstOrder<Real> exact(const FirstOrder<Real>& start, Real t) const {
        using std::cos, std::exp;
        return {start.t + t, cos(start.t + t) + (start.y - cos(start.t)) * exp(lambda * t)};
    }
};

}  // namespace timestep
