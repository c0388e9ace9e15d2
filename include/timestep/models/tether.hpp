#pragma once
/// \file
/// A spring with a length of its own, in two or three dimensions.

#include <timestep/checks.hpp>
#include <timestep/linear_solve.hpp>

namespace timestep {

/// An elastic rope or rod from the origin, a = −ω² (|x| − L) x / |x|: pulls when it is longer than
/// its rest length L, pushes when it is shorter (I03). The pull is along the tether, so the angular
/// momentum x × v never changes. The rest length makes the force nonlinear and ties the components
/// together; with L = 0 it is the Spring, whose components do not know of each other.
template <class Real>
struct Tether {
    Real omega;   ///< angular frequency of the swing along the tether, rad/s
    Real length;  ///< rest length, m

    /// `omega` in rad/s, its square finite, and `length` in m, both zero or more.
    /// Throws `std::invalid_argument`.
    Tether(Real omega_, Real length_)
        : omega(not_negative("omega", omega_)), length(not_negative("length", length_)) {
        if (!std::isfinite(omega * omega))
            refuse("omega", omega, "small enough that its square is finite");
    }

    // The share of x that is stretch, (|x| − L) / |x| = 1 − L / |x|. At the origin the tether has
    // no direction, and we let it exert no force.
    /// −ω² (1 − L/|x|) x, m/s².
    /// [model]
    template <class X>
    X acceleration(const X& x) const {
        return -omega * omega * (1 - length * inverse(magnitude(x))) * x;
    }
    /// [model]

    /// ∂a/∂x = −ω² ((1 − L/|x|) 1 + L x xᵀ / |x|³).
    template <class X>
    auto slope_x(const X& x) const {
        using Slope = decltype(outer(x, x));
        const real_of<X> over_r = inverse(magnitude(x));
        return Slope(-omega * omega *
                     ((1 - length * over_r) * identity<Slope>() +
                      length * over_r * over_r * over_r * outer(x, x)));
    }

    /// Energy per unit of mass, m²/s²: kinetic ½|v|² and stored ½ω²(|x| − L)².
    template <class X>
    real_of<X> energy(const State<X>& s) const {
        const real_of<X> stretch = magnitude(s.x) - length;
        const real_of<X> speed = magnitude(s.v);
        return (speed * speed + omega * omega * stretch * stretch) / 2;
    }

private:
    template <class R>
    static R inverse(R r) {
        return r > 0 ? 1 / r : R(0);
    }
};

}  // namespace timestep
