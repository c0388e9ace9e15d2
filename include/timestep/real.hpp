#pragma once
/// \file
/// The real number type behind a number, a vector or a state; and the type that a state makes of
/// the values it is given, so that a mistake gets one clear message.

#include <concepts>
#include <type_traits>

namespace timestep {

/// Whether `X` is one real number: a built-in one, or a pack that adds and multiplies as one number
/// does (lanes.hpp).
template <class X>
inline constexpr bool is_number = std::is_arithmetic_v<X>;

/// A vector that a State can hold: it names its real number type. Eigen's vectors do; a game's own
/// vector needs one more line.
///
///     struct Vec3 {
///         using Scalar = float;
///         float x, y, z;
///     };
///
/// The methods compute with `a + b`, `a - b`, `number * a` and `a / number`; run() also calls
/// `bool is_finite(const Vec3&)`. Implicit methods need a force whose slopes are numbers, or Eigen.
template <class X>
concept StateVector = requires {
    typename X::Scalar;
};

/// Calls `look(a, b, …)` with real numbers, or lane by lane if they are packs.
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
    using type = double;  // of a type that names none; a State refuses it
};
template <class X>
requires requires { typename X::Scalar; }
struct RealOf<X> {
    using type = typename X::Scalar;  // an Eigen vector, a State
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
template <class A>
requires(!is_number<A> && !requires { typename A::PlainObject; }) struct Kept<A, A> {
    using type = A;  // a vector of your own
};

// Eigen names the vector that an expression computes, and a vector names itself.
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
