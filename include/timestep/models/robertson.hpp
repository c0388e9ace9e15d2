#pragma once
/// \file
/// Three chemicals, and rates that differ by nine powers of ten.

#include <Eigen/Core>

#include <timestep/state.hpp>

namespace timestep {

/// Robertson's reactions (1966): A → B slowly, B + B → C + B very fast, B + C → A + C fast. The
/// shares y₁, y₂, y₃ of A, B and C always add up to one. (Hairer and Wanner, *Solving Ordinary
/// Differential Equations II*, IV.1.)
template <class Real>
struct Robertson {
    using Vector = Eigen::Matrix<Real, 3, 1>;  ///< the shares
    using Matrix = Eigen::Matrix<Real, 3, 3>;  ///< the derivatives

    /// The rates of the three shares.
    /// [model]
    Vector operator()(Real /* t */, const Vector& y) const {
        const Real slow = Real(0.04) * y[0];
        const Real fast = Real(1e4) * y[1] * y[2];
        const Real fastest = Real(3e7) * y[1] * y[1];
        return {-slow + fast, slow - fast - fastest, fastest};
    }
    /// [model]

    /// ∂f/∂y, the derivatives of the rates.
    Matrix slope_y(Real /* t */, const Vector& y) const {
        const Real a = Real(0.04), b = Real(1e4) * y[2], c = Real(1e4) * y[1], d = Real(6e7) * y[1];
        Matrix slope;
        slope << -a, b, c, a, -b - d, -c, 0, d, 0;
        return slope;
    }
};

}  // namespace timestep
