#pragma once
/// \file
/// A body under gravity alone.

#include <timestep/checks.hpp>
#include <timestep/forces.hpp>

namespace timestep {

/// Constant acceleration (N12): `gravity` is the vector, or with one degree of freedom the number,
/// that is added to the velocity each second: −9.81 m/s² when up is positive.
template <class X>
struct Projectile {
    X gravity;  ///< acceleration, m/s²

    /// `gravity` in m/s², finite. Throws `std::invalid_argument`.
    explicit Projectile(const X& gravity_) : gravity(gravity_) {
        if (!is_finite(gravity)) refuse("gravity: must be finite");
    }

    /// Gravity, m/s²: a constant.
    X acceleration() const { return gravity; }

    /// The exact state `t` seconds after `start`: y₀ + v₀ t + ½ a t², a parabola.
    State<X> exact(const State<X>& start, real_of<X> t) const {
        return {start.t + t, start.x + t * start.v + t / 2 * (t * gravity), start.v + t * gravity};
    }
};

}  // namespace timestep
