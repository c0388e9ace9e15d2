#pragma once
/// \file
/// States and their rates of change.

#include <concepts>
#include <type_traits>

#include <timestep/real.hpp>

namespace timestep {

/// The state of a body that obeys Newton's law: time is the independent variable, position and
/// velocity are the dependent ones (talk row I01).
///
/// `X` is a real number, a fixed-size Eigen vector, or a StateVector of your own. Units: s, m, m/s.
template <class X>
struct State {
    static_assert(!std::is_integral_v<X>,
                  "timestep: a state holds real numbers: write 1.0 instead of 1");
    static_assert(!std::same_as<X, detail::NumberAndVector>,
                  "timestep: position and velocity are two numbers, or two vectors of one size");
    static_assert(!detail::is_expression<X>,
                  "timestep: a state holds vectors, not Eigen expressions of them: "
                  "State<Eigen::Vector3d>");
    static_assert(
        is_number<X> || StateVector<X>,
        "timestep: a state needs `using Scalar = ...` in the vector that it holds: its real "
        "number type");
    using Scalar = real_of<X>;  ///< the real number type

    Scalar t;  ///< time, s
    X x;       ///< position, m
    X v;       ///< velocity, m/s
};

/// \cond  State{0, 1.0, 0.0} is a State<double>
template <class X>
State(real_of<X>, X, X) -> State<typename detail::Kept<X, X>::type>;
template <class T, class A, class B>
requires(!std::same_as<A, B>) State(T, A, B)
->State<typename detail::Kept<A, B>::type>;
/// \endcond

/// The rate of change of a State: ẋ and v̇. Rates add and scale as vectors do.
template <class X>
struct Rate {
    using Scalar = real_of<X>;  ///< the real number type

    X x;  ///< ẋ, the velocity, m/s
    X v;  ///< v̇, the acceleration, m/s²

    /// Rates add.
    friend Rate operator+(const Rate& a, const Rate& b) { return {a.x + b.x, a.v + b.v}; }
    /// A rate times a number.
    friend Rate operator*(Scalar s, const Rate& a) { return {s * a.x, s * a.v}; }
    /// A rate over a number.
    friend Rate operator/(const Rate& a, Scalar s) { return {a.x / s, a.v / s}; }
};

/// The state of a first-order system ẏ = f(t, y), one equation or an array of them (N16, I04).
template <class Y>
struct FirstOrder {
    static_assert(!std::is_integral_v<Y>,
                  "timestep: a state holds real numbers: write 1.0 instead of 1");
    static_assert(!detail::is_expression<Y>,
                  "timestep: a state holds vectors, not Eigen expressions of them: "
                  "FirstOrder<Eigen::Vector3d>");
    static_assert(
        is_number<Y> || StateVector<Y>,
        "timestep: a state needs `using Scalar = ...` in the vector that it holds: its real "
        "number type");
    using Scalar = real_of<Y>;  ///< the real number type

    Scalar t;  ///< time, s
    Y y;       ///< the unknowns, in their own units
};

/// \cond
template <class Y>
FirstOrder(real_of<Y>, Y) -> FirstOrder<typename detail::Kept<Y, Y>::type>;
/// \endcond

/// The state after `h` seconds at a constant rate: t + h, x + h ẋ, v + h v̇.
template <class X>
[[nodiscard]] State<X> advance(const State<X>& s, real_of<X> h,
                               const std::type_identity_t<Rate<X>>& rate) {
    return {s.t + h, s.x + h * rate.x, s.v + h * rate.v};
}

/// The state after `h` seconds at a constant rate: t + h, y + h ẏ.
template <class Y>
[[nodiscard]] FirstOrder<Y> advance(const FirstOrder<Y>& s, real_of<Y> h,
                                    const std::type_identity_t<Y>& rate) {
    return {s.t + h, s.y + h * rate};
}

}  // namespace timestep
