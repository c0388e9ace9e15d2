#pragma once
/// \file
/// The eigenvalues and eigenvectors of a symmetric matrix. This works on Eigen's matrices but does
/// not include Eigen, whose own solver takes a second or more to compile in every file.

#include <cmath>
#include <utility>

#include <timestep/real.hpp>

namespace timestep {

/// Replaces the symmetric matrix `a` by the diagonal matrix of its eigenvalues, rising. Returns its
/// eigenvectors as columns, perpendicular and of length one: eigenvectors · a · eigenvectorsᵀ is
/// the original matrix. The size of `a` is known at compile time, and its numbers are finite.
///
/// Jacobi's method rotates the axes i and j by the angle that makes a(i, j) zero, for each pair,
/// and repeats this, because each rotation changes the zeros of earlier ones a little. From the
/// third round on the rest is squared each time; five or six rounds leave nothing. The eigenvalues
/// are off by a few ε of the LARGEST.
template <class Matrix>
Matrix eigenvectors(Matrix& a) {
    using Real = real_of<Matrix>;
    constexpr int n = Matrix::RowsAtCompileTime;
    Matrix axes = Matrix::Identity();
    for (int round = 0; round < 50; ++round) {
        bool diagonal = true;
        for (int i = 0; i < n; ++i)
            for (int j = i + 1; j < n; ++j) {
                if (a(i, j) == 0) continue;
                diagonal = false;
                // cot 2φ = (a(j, j) − a(i, i)) / 2 a(i, j), and t is the tangent of the smaller φ.
                const Real cot = (a(j, j) - a(i, i)) / a(i, j) / 2;
                const Real t = std::copysign(1 / (std::abs(cot) + std::sqrt(1 + cot * cot)), cot);
                const Real c = 1 / std::sqrt(1 + t * t), s = t * c;
                a(i, i) -= t * a(i, j);
                a(j, j) += t * a(i, j);
                a(i, j) = a(j, i) = 0;
                const auto rotate = [&](Real& u, Real& v) {
                    const Real old = u;
                    u = c * old - s * v;
                    v = s * old + c * v;
                };
                for (int k = 0; k < n; ++k) {
                    rotate(axes(k, i), axes(k, j));
                    if (k == i || k == j) continue;
                    rotate(a(k, i), a(k, j));
                    a(i, k) = a(k, i);
                    a(j, k) = a(k, j);
                }
            }
        if (diagonal) break;
    }
    for (int i = 0; i < n; ++i)  // rising
        for (int j = i + 1; j < n; ++j)
            if (a(j, j) < a(i, i)) {
                std::swap(a(i, i), a(j, j));
                for (int k = 0; k < n; ++k) std::swap(axes(k, i), axes(k, j));
            }
    return axes;
}

}  // namespace timestep
