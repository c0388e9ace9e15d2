#pragma once
/// \file
/// Newton's law as an array of first-order equations, the form that every solver takes.

#include <type_traits>

#include <Eigen/Core>

#include <timestep/forces.hpp>
#include <timestep/linear_solve.hpp>

namespace timestep {

/// \cond
namespace detail {

/// How many numbers are in a number or vector, known at compile time.
template <class X>
constexpr int size_of() {
    if constexpr (std::is_same_v<X, real_of<X>>)
        return 1;
    else
        return X::SizeAtCompileTime;
}

/// The vector that y is, or of which it is a piece.
template <class Y>
using Whole = Eigen::Matrix<real_of<Y>, size_of<Y>(), 1>;

/// The positions in y = (x, v): a number if y holds two, else a vector.
template <class Y>
using Half = std::conditional_t<size_of<Y>() == 2, real_of<Y>,
                                Eigen::Matrix<real_of<Y>, size_of<Y>() / 2, 1>>;

template <class X>
Eigen::Matrix<real_of<X>, 2 * size_of<X>(), 1> stack(const X& upper, const X& lower) {
    constexpr int n = size_of<X>();
    Eigen::Matrix<real_of<X>, 2 * n, 1> y;
    if constexpr (n == 1)
        y(0) = upper, y(1) = lower;
    else
        for (int i = 0; i < n; ++i) y(i) = upper(i), y(n + i) = lower(i);
    return y;
}

}  // namespace detail
/// \endcond

/// A body's state as one array y = (x, v).
template <class X>
auto stacked(const State<X>& s) {
    return FirstOrder<decltype(detail::stack(s.x, s.v))>{s.t, detail::stack(s.x, s.v)};
}

/// The state that an array y = (x, v) of even size holds: two numbers, or two vectors.
template <class Y>
auto unstacked(const FirstOrder<Y>& s) {
    using X = detail::Half<Y>;
    if constexpr (std::is_same_v<X, real_of<Y>>)
        return State<X>{s.t, s.y(0), s.y(1)};
    else
        return State<X>{s.t, s.y.template head<X::SizeAtCompileTime>(),
                        s.y.template tail<X::SizeAtCompileTime>()};
}

/// A force as a first-order system ẏ = f(t, y) with y = (x, v), so that ẏ = (v, a(x, v)) (N16,
/// I04). A solver need not know which numbers are positions. Several such systems, one after
/// another in one array, are a system again.
template <class Model>
struct FirstOrderForm {
    Model model;  ///< the force

    /// Copies the model.
    explicit FirstOrderForm(const Model& model_) : model(model_) {}

    /// ẏ for y = (x, v). `y` is a fixed-size vector or a piece of one.
    template <class Y>
    auto operator()(real_of<Y> t, const Y& y) const {
        const FirstOrder<detail::Whole<Y>> state{t, y};
        const auto [velocity, acceleration] = rate(model, unstacked(state));
        return detail::stack(velocity, acceleration);
    }

    /// ∂f/∂y: in the upper rows the ones of ẋ = v, in the lower rows the slopes of the force.
    template <class Y>
    auto slope_y(real_of<Y> t, const Y& y) const requires SmoothForce<Model, detail::Half<Y>> {
        constexpr int n = detail::size_of<Y>() / 2;
        using Block = Eigen::Matrix<real_of<Y>, n, n>;
        const FirstOrder<detail::Whole<Y>> state{t, y};
        const auto [time, x, v] = unstacked(state);
        const Block by_x = matrix<Block>(slope_x(model, x, v));
        const Block by_v = matrix<Block>(slope_v(model, x, v));
        using Slope = Eigen::Matrix<real_of<Y>, 2 * n, 2 * n>;
        Slope slope = Slope::Zero();
        for (int i = 0; i < n; ++i) {
            slope(i, n + i) = 1;
            for (int j = 0; j < n; ++j) {
                slope(n + i, j) = by_x(i, j);
                slope(n + i, n + j) = by_v(i, j);
            }
        }
        return slope;
    }

private:
    template <class Block, class A>
    static Block matrix(const A& a) {
        if constexpr (is_number<A>)
            return a * Block::Identity();
        else
            return a;
    }
};

}  // namespace timestep
