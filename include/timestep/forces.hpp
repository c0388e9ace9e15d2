#pragma once
/// \file
/// What a force depends on. A model declares it by the arguments of its `acceleration`, and gets no
/// others:
///
///     acceleration()        constant           ConstantForce
///     acceleration(x)       position only      PositionForce
///     acceleration(x, v)    and velocity       VelocityForce
///
/// The partial derivatives ∂a/∂x and ∂a/∂v, which implicit methods need, follow that rule:
/// `slope_x()` and `slope_v()` without arguments are constants, so the model is linear. If a model
/// has several overloads, the one with the fewest arguments is used.

#include <timestep/state.hpp>

namespace timestep {

/// The acceleration is constant.
template <class Model>
concept ConstantForce = requires(const Model& m) {
    m.acceleration();
};

/// The acceleration depends on the position at most.
template <class Model, class X>
concept PositionForce = ConstantForce<Model> || requires(const Model& m, const X& x) {
    m.acceleration(x);
};

/// The acceleration depends on position and velocity at most.
template <class Model, class X>
concept VelocityForce = PositionForce<Model, X> ||
    requires(const Model& m, const X& x, const X& v) {
    m.acceleration(x, v);
};

/// \cond
namespace detail {
// The model's acceleration in the type in which the model gives it.
template <class Model, class X>
decltype(auto) given_acceleration(const Model& model, const X& x) {
    if constexpr (ConstantForce<Model>)
        return model.acceleration();
    else
        return model.acceleration(x);
}
template <class Model, class X>
decltype(auto) given_acceleration(const Model& model, const X& x, const X& v) {
    if constexpr (PositionForce<Model, X>)
        return given_acceleration(model, x);
    else
        return model.acceleration(x, v);
}
template <class Given, class X>
struct AccelerationFits {
    static_assert(std::is_convertible_v<Given, X>,
                  "timestep: the acceleration must be what the position is: a number, or a vector "
                  "of the same size");
};
}  // namespace detail
/// \endcond

/// The acceleration of `model` at position `x` and velocity `v`, m/s².
template <class X, class Model>
X acceleration(const Model& model, const X& x, const X& v) {
    static_assert(VelocityForce<Model, X>,
                  "timestep: a model needs a const member acceleration(), acceleration(x) or "
                  "acceleration(x, v)");
    if constexpr (VelocityForce<Model, X>) {
        using Given = decltype(detail::given_acceleration(model, x, v));
        [[maybe_unused]] const detail::AccelerationFits<Given, X> fits;
        return detail::given_acceleration(model, x, v);
    }
}

/// The acceleration of `model` at position `x`, m/s². Methods of Verlet's kind use it, because they
/// evaluate the force before they know the velocity (I08).
template <class X, class Model>
X acceleration(const Model& model, const X& x) {
    static_assert(PositionForce<Model, X>,
                  "timestep: Verlet has no velocity to hand to a force: it needs acceleration() or "
                  "acceleration(x)");
    if constexpr (PositionForce<Model, X>) {
        using Given = decltype(detail::given_acceleration(model, x));
        [[maybe_unused]] const detail::AccelerationFits<Given, X> fits;
        return detail::given_acceleration(model, x);
    }
}

/// The rate of change of a body's state, Newton's law in first-order form (N16, I04):
/// ẋ = v and v̇ = a(x, v).
template <class Model, class X>
Rate<X> rate(const Model& model, const State<X>& s) {
    return {s.v, acceleration(model, s.x, s.v)};
}

/// The rate of change of a first-order system: f(t, y).
template <class System, class Y>
Y rate(const System& f, const FirstOrder<Y>& s) {
    static_assert(
        requires { f(s.t, s.y); }, "timestep: a first-order system needs f(t, y)");
    return f(s.t, s.y);
}

/// \cond
namespace detail {
// A sum of forces is linear, or smooth, only if all of its parts are (scene.hpp).
template <class Model, class X>
inline constexpr bool parts_are_linear = true;
template <class Model, class X>
inline constexpr bool parts_are_smooth = true;
template <class Model, class X>
inline constexpr bool parts_damp_linearly = requires(const Model& m) {
    m.slope_v();
};

template <class Model, class X>
concept HasSlopeX = requires(const Model& m) {
    m.slope_x();
}
|| requires(const Model& m, const X& x) { m.slope_x(x); }
|| requires(const Model& m, const X& x, const X& v) { m.slope_x(x, v); };
template <class Model, class X>
concept HasSlopeV = requires(const Model& m) {
    m.slope_v();
}
|| requires(const Model& m, const X& x) { m.slope_v(x); }
|| requires(const Model& m, const X& x, const X& v) { m.slope_v(x, v); };
}  // namespace detail
/// \endcond

/// A force whose derivatives are constant: a = a₀ + slope_x·x + slope_v·v.
/// For such models implicit methods need one linear solve and no iteration.
template <class Model, class X>
concept LinearForce = ConstantForce<Model> ||
    (requires(const Model& m) { m.slope_x(); } &&
     (PositionForce<Model, X> || requires(const Model& m) { m.slope_v(); }) &&
     detail::parts_are_linear<Model, X>);

/// A force that is linear in the velocity or does not depend on it: a = a(x, 0) + slope_v·v with a
/// constant slope_v. It may depend on the position in any way.
template <class Model, class X>
concept LinearDamping = PositionForce<Model, X> || detail::parts_damp_linearly<Model, X>;

/// A force that carries its derivatives, constant or not.
template <class Model, class X>
concept SmoothForce = ConstantForce<Model> ||
    (detail::HasSlopeX<Model, X> &&
     (PositionForce<Model, X> || detail::HasSlopeV<Model, X>)&&detail::parts_are_smooth<Model, X>);

/// ∂a/∂x at (x, v), 1/s²: a number or a matrix. Of several overloads the one with most arguments
/// is called: a sum of forces has a slope without arguments from its constant parts alone.
template <class X, class Model>
auto slope_x(const Model& model, const X& x, const X& v) {
    if constexpr (ConstantForce<Model>)
        return real_of<X>(0);
    else if constexpr (requires { model.slope_x(x, v); })
        return model.slope_x(x, v);
    else if constexpr (requires { model.slope_x(x); })
        return model.slope_x(x);
    else
        return model.slope_x();
}

/// ∂a/∂v at (x, v), 1/s: a number or a matrix.
template <class X, class Model>
auto slope_v(const Model& model, const X& x, const X& v) {
    if constexpr (PositionForce<Model, X>)
        return real_of<X>(0);
    else if constexpr (requires { model.slope_v(x, v); })
        return model.slope_v(x, v);
    else if constexpr (requires { model.slope_v(x); })
        return model.slope_v(x);
    else
        return model.slope_v();
}

}  // namespace timestep
