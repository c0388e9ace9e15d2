#pragma once
/// \file
/// An oscillator that creeps and jumps.

#include <Eigen/Core>

#include <timestep/checks.hpp>

namespace timestep {

/// Van der Pol's oscillator in its stiff scaling, ẏ₁ = y₂ and ẏ₂ = μ ((1 − y₁²) y₂ − y₁). For large
/// μ it creeps along |y₁| > 1, and jumps across in a time of about 1/μ. (Hairer and Wanner,
/// *Solving Ordinary Differential Equations II*, IV.1.)
template <class Real>
struct VanDerPol {
    using Vector = Eigen::Matrix<Real, 2, 1>;  ///< y₁ and y₂
    using Matrix = Eigen::Matrix<Real, 2, 2>;  ///< the derivatives
    Real mu;                                   ///< stiffness, 1/s²

    /// `mu` above zero. Throws `std::invalid_argument`.
    explicit VanDerPol(Real mu_) : mu(positive("mu", mu_)) {}

    /// The rates of y₁ and y₂.
    Vector operator()(Real /* t */, const Vector& y) const {
        return {y[1], mu * ((1 - y[0] * y[0]) * y[1] - y[0])};
    }

    /// ∂f/∂y, the derivatives of the rates.
    Matrix slope_y(Real /* t */, const Vector& y) const {
        Matrix slope;
        slope << 0, 1, -mu * (2 * y[0] * y[1] + 1), mu * (1 - y[0] * y[0]);
        return slope;
    }
};

}  // namespace timestep
