#pragma once
/// \file
/// Which real number stands behind a number, a vector or a state; and what a state makes of the
/// values it is given, so that a mistake meets one clear message.

#include <concepts>
#include <type_traits>

namespace timestep {

/// Is `X` one real number, a built-in one, or a pack of them that adds and multiplies as one does
/// (lanes.hpp)?
template <class X>
inline constexpr bool is_number = std::is_arithmetic_v<X>;

/// Calls `look(a, b, …)` with real numbers, or lane by lane where they are packs of them.
template <class Look, class Real, class... More>
constexpr void for_each_number(const Look& look, const Real& a, const More&... more) {
    if constexpr (std::is_arithmetic_v<Real>)
        look(a, more...);
    else
        for (int i = 0; i < Real::lanes; ++i) look(a[i], more[i]...);
}

/// \cond
namespace detail {
template <class X>
struct RealOf {
    using type = typename X::Scalar;  // an Eigen vector, a State: they name their real number
};
template <class X>
requires is_number<X>
struct RealOf<X> {
    using type = X;
};

// What a state keeps of a position A and a velocity B: 0 and 1.0 are real numbers; an Eigen
// expression becomes the vector that it computes; a number and a vector are a mistake.
struct NumberAndVector {
    using Scalar = double;
};
template <class A, class B>
struct Kept {
    using type = NumberAndVector;
};
template <class A, class B>
requires is_number<A> && is_number<B>
struct Kept<A, B> : std::common_type<A, B> {
};
template <class A, class B>
requires std::same_as<typename A::PlainObject, typename B::PlainObject>
struct Kept<A, B> {
    using type = typename A::PlainObject;
};

// Eigen names the vector that an expression computes; a vector names itself.
template <class X>
inline constexpr bool is_expression = false;
template <class X>
requires requires { typename X::PlainObject; }
inline constexpr bool is_expression<X> = !std::same_as<X, typename X::PlainObject>;
}  // namespace detail
/// \endcond

/// The real number type behind `X`: `double` for `double`, for `Eigen::Vector3d` and for
/// `State<double>`.
template <class X>
using real_of = typename detail::RealOf<X>::type;

}  // namespace timestep
