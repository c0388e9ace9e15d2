#pragma once
/// \file
/// Which real number stands behind a number, a vector or a state; and what a state makes of the
/// values it is given, so that a mistake meets one clear message.

#include <concepts>
#include <type_traits>

namespace timestep {

/// \cond
namespace detail {
template <class X>
struct RealOf {
    using type = typename X::Scalar;  // an Eigen vector, a State: they name their real number
};
template <class X>
    requires std::is_arithmetic_v<X>
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
    requires std::is_arithmetic_v<A> && std::is_arithmetic_v<B>
struct Kept<A, B> : std::common_type<A, B> {};
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
