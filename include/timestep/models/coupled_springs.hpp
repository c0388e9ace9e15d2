#pragma once
/// \file
/// Masses in a row, coupled by springs.

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include <timestep/checks.hpp>
#include <timestep/eigenvectors.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// N masses in a row between two walls, N + 1 springs between them (N16):
///
///     wall ~k₀~ m₀ ~k₁~ m₁ ~ … ~k₍N₎~ wall
///
/// x holds the displacements from equilibrium. Each mass feels its neighbours, so no mass can be
/// solved alone: M ẍ = −K x with the mass matrix M (diagonal) and the stiffness matrix K
/// (tridiagonal). A spring of stiffness zero is no spring: with k₀ = 0 the row has a free end.
///
/// The row swings in N patterns, its normal modes, each at one frequency of its own, and every
/// motion is a sum of them.
///
/// The squares of the frequencies are accurate to a few ε of the LARGEST of them. So in a row of
/// both stiff and soft springs the slow modes are inaccurate: an ω² that is 1e-6 of the largest
/// loses six digits, and one that is ε of it or less loses all. This affects `frequencies`, `modes`
/// and `exact`, not the acceleration.
template <class Real, int N>
class CoupledSprings {
public:
    using Vector = Eigen::Matrix<Real, N, 1>;  ///< a number for each mass
    using Matrix = Eigen::Matrix<Real, N, N>;  ///< a number for each pair of masses

    /// Masses in kg, above zero; stiffnesses in N/m, zero or more. Throws `std::invalid_argument`.
    CoupledSprings(const Vector& masses, const Eigen::Matrix<Real, N + 1, 1>& stiffnesses) {
        static_assert(N > 0, "timestep: the number of masses must be known at compile time");
        for (const Real m : masses) positive("mass", m);
        for (const Real k : stiffnesses) not_negative("stiffness", k);

        // Spring i sits left of mass i and stretches by x(i) − x(i − 1).
        Matrix stiffness = Matrix::Zero();
        for (int i = 0; i < N; ++i) {
            stiffness(i, i) = stiffnesses(i) + stiffnesses(i + 1);
            if (i > 0) stiffness(i, i - 1) = stiffness(i - 1, i) = -stiffnesses(i);
        }
        slope_x_ = -(masses.cwiseInverse().asDiagonal() * stiffness);
        if (!is_finite(slope_x_)) refuse("stiffness / mass: must be finite for every mass");
        find_modes(masses, stiffness, free_pieces(stiffnesses));
    }

    /// The accelerations −M⁻¹ K x, m/s².
    template <class X>
    X acceleration(const X& x) const {
        return times(slope_x_, x);
    }

    /// ∂a/∂x = −M⁻¹ K, 1/s².
    const Matrix& slope_x() const { return slope_x_; }

    /// The angular frequencies of the normal modes, rising, rad/s.
    const Vector& frequencies() const { return frequencies_; }
    /// The normal modes: column i is the pattern of displacements that swings at frequency i.
    const Matrix& modes() const { return from_modes_; }

    /// The exact state `t` seconds after `start`: each mode is a spring.
    template <class X>
    State<X> exact(const State<X>& start, real_of<X> t) const {
        using Number = real_of<X>;
        X x = to_modes_.template cast<Number>() * start.x;
        X v = to_modes_.template cast<Number>() * start.v;
        for (int i = 0; i < N; ++i) {
            const Spring<Real> mode(frequencies_(i));
            const State<Number> s = mode.exact(State<Number>{0, x(i), v(i)}, t);
            x(i) = s.x;
            v(i) = s.v;
        }
        return {start.t + t, from_modes_.template cast<Number>() * x,
                from_modes_.template cast<Number>() * v};
    }

private:
    // With y = M^½ x the equation becomes ÿ = −S y, where S = M^−½ K M^−½ is symmetric: it has N
    // eigenvectors at right angles to each other, the columns of Q, and its eigenvalues are ω² ≥ 0.
    // So Qᵀ M^½ takes x to its modes and M^−½ Q takes it back.
    //
    // Roundoff leaves some ε of the largest ω² where ω² is zero. A row swings at frequency zero in
    // as many modes as it has pieces that no spring ties to a wall; so many are zero exactly.
    void find_modes(const Vector& masses, const Matrix& stiffness, int zeros) {
        const Vector root = masses.cwiseSqrt();
        const Vector over_root = root.cwiseInverse();
        Matrix s = over_root.asDiagonal() * stiffness * over_root.asDiagonal();
        const Matrix q = eigenvectors(s);
        for (int i = 0; i < N; ++i)
            frequencies_(i) = i < zeros ? Real(0) : std::sqrt(std::max(s(i, i), Real(0)));
        to_modes_ = q.transpose() * root.asDiagonal();
        from_modes_ = over_root.asDiagonal() * q;
    }

    // A piece goes from one spring of stiffness zero to the next.
    static int free_pieces(const Eigen::Matrix<Real, N + 1, 1>& stiffnesses) {
        int ends = 0;
        for (const Real k : stiffnesses) ends += k == 0;
        return ends > 0 ? ends - 1 : 0;
    }

    Matrix slope_x_, to_modes_, from_modes_;
    Vector frequencies_;
};

/// \cond
template <class Real, int N>
CoupledSprings(Eigen::Matrix<Real, N, 1>, Eigen::Matrix<Real, N + 1, 1>) -> CoupledSprings<Real, N>;
/// \endcond

}  // namespace timestep
