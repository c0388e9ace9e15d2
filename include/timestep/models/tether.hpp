#pragma once
/// \file
/// A spring with a rest length, in two or three dimensions.

#include <timestep/checks.hpp>
#include <timestep/linear_solve.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// An elastic rope or rod from the origin, a = −ω² (|x| − L) x / |x|: pulls when it is longer than
/// its rest length L, pushes when it is shorter (I03). The pull is along the tether, so the angular
/// momentum x × v never changes. The rest length makes the force nonlinear and ties the components
/// together; with L = 0 it is the Spring, whose components are independent.
template <class Real>
struct Tether {
    Real omega;   ///< angular frequency of the oscillation along the tether, rad/s
    Real length;  ///< rest length, m

    /// `omega` in rad/s, its square finite, and `length` in m, both zero or more.
    /// Throws `std::invalid_argument`.
    Tether(Real omega_, Real length_)
        : omega(not_negative("omega", omega_)), length(not_negative("length", length_)) {
        if (!std::isfinite(omega * omega))
            refuse("omega", omega, "small enough that its square is finite");
    }

    // With the direction u = x / |x| of the tether, (|x| − L) u = x − L u is the stretch. At the
    // origin the tether has no direction, and exerts no force.
    /// The acceleration −ω² (x − L u), m/s².
    template <class X>
    X acceleration(const X& x) const {
        return -omega * omega * (x - length * direction(x));
    }

    /// ∂a/∂x = −ω² (1 − L/|x| (1 − u uᵀ)), 1/s²: along the tether that of a spring. Across it,
    /// L/|x| grows without limit towards the origin; where it overflows, it counts as 0.
    template <class X>
    auto slope_x(const X& x) const {
        using Number = real_of<X>;
        if constexpr (std::is_floating_point_v<X>) {
            return Number(-omega * omega);  // on a line nothing is across
        } else {
            using Slope = decltype(outer(x, x));
            const X u = direction(x);
            Number across = Number(omega * omega * length) / dot(u, x);  // ω² L/|x|, without |x|²
            if (!is_finite(across)) across = 0;
            return Slope(across * (identity<Slope>() - outer(u, u)) -
                         omega * omega * identity<Slope>());
        }
    }

    /// Energy per unit of mass, m²/s²: kinetic ½|v|² and stored ½ω²(|x| − L)².
    template <class X>
    real_of<X> energy(const State<X>& s) const {
        const real_of<X> stretch = magnitude(s.x) - length;
        const real_of<X> speed = magnitude(s.v);
        return (speed * speed + omega * omega * stretch * stretch) / 2;
    }
};

}  // namespace timestep
