#pragma once
/// \file
/// Air resistance.

#include <timestep/checks.hpp>
#include <timestep/linear_solve.hpp>

namespace timestep {

/// Quadratic air resistance, a = −k |v| v: against the motion, and four times as strong at twice
/// the speed (I03). For a body of mass m and cross-section A with drag coefficient C in air of
/// density ρ, k = ρ C A / (2 m). The force is nonlinear, and in two or three dimensions it ties
/// the components of the velocity together: a projectile with drag has no simple exact solution.
template <class Real>
struct Drag {
    Real k;  ///< drag per unit of mass, 1/m

    /// `k` in 1/m, zero or more. Throws `std::invalid_argument`.
    explicit Drag(Real k_) : k(not_negative("drag", k_)) {}

    /// The drag whose terminal `speed`, m/s, under `gravity`, m/s², is given: k v² = g. Throws
    /// `std::invalid_argument`.
    static Drag from_terminal_speed(Real speed, Real gravity) {
        return Drag(not_negative("gravity", gravity) / positive("terminal speed", speed) / speed);
    }

    /// The acceleration −k |v| v, m/s².
    /// [model]
    template <class X>
    X acceleration(const X& /* x */, const X& v) const {
        return -k * magnitude(v) * v;
    }
    /// [model]

    /// ∂a/∂x = 0.
    template <class X>
    Real slope_x(const X& /* x */, const X& /* v */) const {
        return 0;
    }

    /// ∂a/∂v = −k |v| (1 + u uᵀ), 1/s, with the direction u = v / |v|; 0 at rest. The formula uses
    /// u and not v vᵀ / |v|: near rest v vᵀ underflows and 1 / |v| overflows.
    template <class X>
    auto slope_v(const X& /* x */, const X& v) const {
        using Slope = decltype(outer(v, v));
        const X u = direction(v);
        return Slope(-k * magnitude(v) * (identity<Slope>() + outer(u, u)));
    }
};

}  // namespace timestep
