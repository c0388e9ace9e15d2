#pragma once
/// \file
/// The mass-spring-damper.

#include <cmath>

#include <timestep/checks.hpp>
#include <timestep/forces.hpp>

namespace timestep {

/// A spring with a damper, a = −ω² x − 2ζω v (N17).
///
/// Dividing m ẍ = −k x − c v by the mass leaves two parameters: ω = √(k/m) and the damping ratio
/// ζ = c / (2√(k m)). ζ = 0 swings for ever, ζ = 1 is critical, ζ > 1 does not swing at all.
template <class Real>
struct DampedSpring {
    Real omega;  ///< angular frequency without damping, rad/s
    Real zeta;   ///< damping ratio, no unit

    /// `omega` in rad/s and `zeta`, both zero or more; ω² and 2ζω finite.
    /// Throws `std::invalid_argument`.
    DampedSpring(Real omega_, Real zeta_)
        : omega(not_negative("omega", omega_)), zeta(not_negative("zeta", zeta_)) {
        if (!std::isfinite(omega * omega)) refuse("omega", omega, "small enough that its square is finite");
        if (!std::isfinite(2 * zeta * omega)) refuse("zeta", zeta, "small enough that 2 zeta omega is finite");
    }

    /// [model]
    template <class X>
    X acceleration(const X& x, const X& v) const {
        return -omega * omega * x - 2 * zeta * omega * v;
    }
    /// [model]

    Real slope_x() const { return -omega * omega; }        ///< ∂a/∂x, 1/s²
    Real slope_v() const { return -2 * zeta * omega; }     ///< ∂a/∂v, 1/s
};

}  // namespace timestep
