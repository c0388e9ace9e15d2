#pragma once
/// \file
/// Several forces on one body: a scene is the sum of the models it names, put together by the
/// compiler.

#include <tuple>

#include <timestep/forces.hpp>
#include <timestep/linear_solve.hpp>

namespace timestep {

/// \cond
namespace detail {

struct Absent {};  // the slope of a force that has none: costs no addition

template <class A, class B>
auto plus(const A& a, const B& b) {
    if constexpr (std::is_same_v<A, Absent>)
        return b;
    else if constexpr (std::is_same_v<B, Absent>)
        return a;
    else {
        using Sum = std::conditional_t<is_number<A>, B, A>;  // a matrix if either is
        return Sum(times_identity<Sum>(a) + times_identity<Sum>(b));
    }
}
template <class A>
A sum(const A& a) {
    return a;
}
template <class A, class B, class... More>
auto sum(const A& a, const B& b, const More&... more) {
    return sum(plus(a, b), more...);
}

template <class Model>
concept ConstantSlopeX = requires(const Model& m) {
    m.slope_x();
};
template <class Model>
concept ConstantSlopeV = requires(const Model& m) {
    m.slope_v();
};

}  // namespace detail
/// \endcond

/// The forces of all `Parts` together: `Scene{Projectile{g}, Drag{k}}` is a shell in flight,
/// `Scene{DampedSpring{omega, zeta}, Projectile{-9.81}}` a character on its legs (I03, I14).
///
/// A scene is a model. Its acceleration is the sum of those of its parts, in their order, and takes
/// only the arguments that they take; it is linear if all of them are. Terms that are not named
/// cost no instruction.
template <class... Parts>
class Scene {
    static_assert(sizeof...(Parts) > 0, "timestep: a scene needs at least one force");

    template <class X>
    static constexpr bool position_only = (PositionForce<Parts, X> && ...);
    static constexpr bool constant = (ConstantForce<Parts> && ...);
    template <class X>
    static constexpr bool linear = (LinearForce<Parts, X> && ...);
    template <class X>
    static constexpr bool smooth = (SmoothForce<Parts, X> && ...);
    static constexpr bool constant_slope_x =
        ((ConstantForce<Parts> || detail::ConstantSlopeX<Parts>)&&...);

public:
    /// Copies the parts, which have checked their parameters.
    explicit Scene(const Parts&... parts) : parts_(parts...) {}

    /// The sum of constant forces, per unit of mass.
    auto acceleration() const requires constant {
        return of_parts([](const auto& first, const auto&... more) {
            using X = std::remove_cvref_t<decltype(first.acceleration())>;
            return X((first.acceleration() + ... + more.acceleration()));
        });
    }
    /// The sum of forces that depend on the position at most, per unit of mass.
    template <class X>
    X acceleration(const X& x) const requires(position_only<X> && !constant) {
        return of_parts(
            [&](const auto&... part) -> X { return (... + timestep::acceleration(part, x)); });
    }
    /// The sum of forces of which one depends on the velocity, per unit of mass.
    template <class X>
    X acceleration(const X& x, const X& v) const
        requires((VelocityForce<Parts, X> && ...) && !position_only<X>) {
        return of_parts(
            [&](const auto&... part) -> X { return (... + timestep::acceleration(part, x, v)); });
    }

    /// ∂a/∂x, 1/s², of a scene whose slope is constant.
    auto slope_x() const requires(constant_slope_x && !constant) {
        return of_parts([](const auto&... part) { return detail::sum(part_slope_x(part)...); });
    }
    /// ∂a/∂v, 1/s, of a scene that is a LinearForce.
    auto slope_v() const requires(constant_slope_x && (detail::ConstantSlopeV<Parts> || ...)) {
        return of_parts([](const auto&... part) { return detail::sum(part_slope_v(part)...); });
    }

    /// ∂a/∂x at (x, v), 1/s².
    template <class X>
    auto slope_x(const X& x, const X& v) const requires(!linear<X> && smooth<X>) {
        return of_parts(
            [&](const auto&... part) { return detail::sum(part_slope_x(part, x, v)...); });
    }
    /// ∂a/∂v at (x, v), 1/s.
    template <class X>
    auto slope_v(const X& x, const X& v) const
        requires(!linear<X> && !position_only<X> &&
                 ((PositionForce<Parts, X> || detail::HasSlopeV<Parts, X>)&&...)) {
        return of_parts(
            [&](const auto&... part) { return detail::sum(part_slope_v(part, x, v)...); });
    }

private:
    template <class Sum>
    auto of_parts(const Sum& sum) const {
        return std::apply(sum, parts_);
    }

    // What one part adds; `xv` is x, v or nothing.
    template <class Part, class... XV>
    static auto part_slope_x(const Part& part, const XV&... xv) {
        if constexpr (ConstantForce<Part>)
            return detail::Absent{};
        else if constexpr (detail::ConstantSlopeX<Part>)
            return part.slope_x();
        else
            return timestep::slope_x(part, xv...);
    }
    template <class Part, class... XV>
    static auto part_slope_v(const Part& part, const XV&... xv) {
        if constexpr (requires { part.slope_v(xv...); })
            return part.slope_v(xv...);
        else if constexpr (detail::ConstantSlopeV<Part>)
            return part.slope_v();
        else
            return detail::Absent{};
    }

    std::tuple<Parts...> parts_;
};

/// \cond
namespace detail {
template <class... Parts, class X>
inline constexpr bool parts_are_linear<Scene<Parts...>, X> = (LinearForce<Parts, X> && ...);
template <class... Parts, class X>
inline constexpr bool parts_are_smooth<Scene<Parts...>, X> = (SmoothForce<Parts, X> && ...);
template <class... Parts, class X>
inline constexpr bool parts_damp_linearly<Scene<Parts...>, X> = (LinearDamping<Parts, X> && ...);
}  // namespace detail
/// \endcond

}  // namespace timestep
