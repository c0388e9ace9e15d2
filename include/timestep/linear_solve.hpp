#pragma once
/// \file
/// The operations in which numbers and matrices differ when an implicit method solves for its new
/// state. They work on Eigen's types but do not include Eigen.

#include <cmath>
#include <type_traits>
#include <utility>

#include <timestep/state.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// The 1 of numbers and of matrices.
template <class A>
A identity() {
    if constexpr (is_number<A>)
        return A(1);
    else
        return A::Identity();
}

/// The 0 of numbers and of vectors.
template <class X>
X zero() {
    if constexpr (requires { X::Zero(); })
        return X::Zero();
    else
        return X{};
}

/// Returns a matrix as it is, and a number as that number times the identity.
template <class Matrix, class A>
Matrix times_identity(const A& a) {
    if constexpr (std::is_convertible_v<A, Matrix>)
        return a;
    else
        return a * Matrix::Identity();
}

/// 1 − h A − h² B, the matrix of an implicit step with the slopes A = ∂a/∂v and B = ∂a/∂x. Either
/// may be a number, which stands for that number times the identity; with two numbers no matrix
/// is built at all.
template <class Real, class A, class B>
auto implicit_matrix(Real h, const A& slope_v, const B& slope_x) {
    using Matrix = std::conditional_t<is_number<A>, B, A>;
    return Matrix(identity<Matrix>() - h * times_identity<Matrix>(slope_v) -
                  h * h * times_identity<Matrix>(slope_x));
}

/// The size of a number or vector: its absolute value or norm.
template <class X>
real_of<X> magnitude(const X& x) {
    if constexpr (is_number<X>)
        return x < 0 ? -x : x;
    else
        return norm(x);
}

/// The size of a number or vector, also if the squares of its parts overflow or underflow; costs
/// twice as much as magnitude(). NaN if a part is infinite or NaN.
template <class X>
real_of<X> safe_magnitude(const X& x) {
    if constexpr (is_number<X>)
        return magnitude(x);
    else {
        real_of<X> largest = 0;
        for (const auto& part : x)
            if (!(magnitude(part) <= largest)) largest = magnitude(part);
        if (largest == 0) return largest;
        real_of<X> sum = 0;  // NaN where a part is, or is infinite
        for (const auto& part : x) sum += (part / largest) * (part / largest);
        return largest * std::sqrt(sum);
    }
}

/// The x with A x = b by Gauss's elimination, for few equations. In each column the largest
/// remaining number is the pivot, so no factor exceeds one. (Eigen's solver takes any size, and
/// seconds to compile.)
template <class Matrix, class X>
X eliminate(Matrix a, X b) {
    constexpr int n = Matrix::RowsAtCompileTime;
    for (int k = 0; k < n; ++k) {
        int pivot = k;
        for (int i = k + 1; i < n; ++i)
            if (magnitude(a(i, k)) > magnitude(a(pivot, k))) pivot = i;
        for (int j = 0; j < n; ++j) std::swap(a(k, j), a(pivot, j));
        std::swap(b(k), b(pivot));
        for (int i = k + 1; i < n; ++i) {
            a(i, k) /= a(k, k);  // the share, kept where it has made a zero
            for (int j = k + 1; j < n; ++j) a(i, j) -= a(i, k) * a(k, j);
        }
    }
    for (int i = 1; i < n; ++i) {  // the right side loses the same shares
        real_of<X> taken = 0;
        for (int j = i - 1; j >= 0; --j) taken += a(i, j) * b(j);
        b(i) -= taken;
    }
    for (int i = n - 1; i >= 0; --i) {  // the last equation has one unknown, the one before it two
        real_of<X> known = 0;
        for (int j = n - 1; j > i; --j) known += a(i, j) * b(j);
        b(i) = (b(i) - known) / a(i, i);
    }
    return b;
}

/// The x with A x = b: a division, or an elimination. A number A stands for A times the identity.
template <class A, class X>
X solve(const A& a, const X& b) {
    if constexpr (is_number<A>)
        return b / a;
    else if constexpr (0 < A::RowsAtCompileTime && A::RowsAtCompileTime <= 4)
        return eliminate<typename A::PlainObject>(a, b);
    else
        return a.partialPivLu().solve(b);
}

/// The direction x / |x|; for a number its sign. Zero has no direction and stays zero. Short
/// vectors are divided by their largest part first, because their squares would underflow.
template <class X>
X direction(const X& x) {
    if constexpr (is_number<X>)
        return x == 0 ? x : x / magnitude(x);
    else {
        const real_of<X> largest = x.cwiseAbs().maxCoeff();
        if (largest == real_of<X>(0)) return x;
        const X scaled = x / largest;
        return scaled / norm(scaled);
    }
}

/// x yᵀ: the product of two numbers, or of two vectors the matrix of all products.
template <class X>
auto outer(const X& x, const X& y) {
    if constexpr (is_number<X>)
        return x * y;
    else {
        using Matrix = typename decltype(x * y.transpose())::PlainObject;
        return Matrix(x * y.transpose());
    }
}

}  // namespace timestep
