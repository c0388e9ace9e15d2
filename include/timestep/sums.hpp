#pragma once
/// \file
/// Products of vectors, matrices and quaternions whose sums have one order on every machine.
///
/// (a + b) + c is not a + (b + c). Eigen adds in the order that suits the processor: SSE2, AVX and
/// NEON differ, and with AVX2 Eigen contracts products and sums. Steps use these functions instead.
/// They work on Eigen's types but do not include Eigen.

#include <cmath>

#include <timestep/inline.hpp>
#include <timestep/real.hpp>

namespace timestep {

/// \cond
namespace detail {
// Row i of A by column j of B, from k on so many of the products: the sums of the two halves. A
// tree of sums takes no longer than a row of them.
template <int k, int count, class A, class B>
TIMESTEP_INLINE real_of<A> row_by_column(const A& a, int i, const B& b, int j) {
    if constexpr (count == 1)
        return a.coeff(i, k) * b.coeff(k, j);
    else
        return row_by_column<k, count / 2>(a, i, b, j) +
               row_by_column<k + count / 2, count - count / 2>(a, i, b, j);
}
template <int k, int count, class A, class B>
TIMESTEP_INLINE real_of<A> dot_part(const A& a, const B& b) {
    if constexpr (count == 1)
        return a.coeff(k) * b.coeff(k);
    else
        return dot_part<k, count / 2>(a, b) + dot_part<k + count / 2, count - count / 2>(a, b);
}
}  // namespace detail
/// \endcond

/// The dot product a · b.
template <class A, class B>
TIMESTEP_INLINE real_of<A> dot(const A& a, const B& b) {
    return detail::dot_part<0, A::SizeAtCompileTime>(a, b);
}

/// The length |a|.
template <class A>
TIMESTEP_INLINE real_of<A> norm(const A& a) {
    using std::sqrt;
    return sqrt(dot(a, a));
}

/// The product A B of a square matrix and a vector or a matrix.
template <class A, class B>
TIMESTEP_INLINE typename B::PlainObject times(const A& a, const B& b) {
    constexpr int n = A::RowsAtCompileTime;
    typename B::PlainObject product;
    for (int j = 0; j < B::ColsAtCompileTime; ++j)
        for (int i = 0; i < n; ++i)
            product.coeffRef(i, j) = detail::row_by_column<0, n>(a, i, b, j);
    return product;
}

/// The product p q of quaternions: the rotation q, then p.
template <class Quaternion>
TIMESTEP_INLINE Quaternion quaternion_product(const Quaternion& p, const Quaternion& q) {
    return Quaternion(p.w() * q.w() - p.x() * q.x() - p.y() * q.y() - p.z() * q.z(),
                      p.w() * q.x() + p.x() * q.w() + p.y() * q.z() - p.z() * q.y(),
                      p.w() * q.y() + p.y() * q.w() + p.z() * q.x() - p.x() * q.z(),
                      p.w() * q.z() + p.z() * q.w() + p.x() * q.y() - p.y() * q.x());
}

/// The product of the quaternion (0, a) and q.
template <class Vector, class Quaternion>
TIMESTEP_INLINE Quaternion vector_product(const Vector& a, const Quaternion& q) {
    return Quaternion(-(a.x() * q.x() + (a.y() * q.y() + a.z() * q.z())),
                      a.x() * q.w() + a.y() * q.z() - a.z() * q.y(),
                      a.y() * q.w() + a.z() * q.x() - a.x() * q.z(),
                      a.z() * q.w() + a.x() * q.y() - a.y() * q.x());
}

}  // namespace timestep
