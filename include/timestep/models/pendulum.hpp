#pragma once
/// \file
/// The pendulum: a spring that is not linear.

#include <cmath>

#include <timestep/checks.hpp>
#include <timestep/forces.hpp>

namespace timestep {

/// A pendulum, a = −ω² sin x, where x is the angle from hanging straight down, in rad, and
/// ω = √(g/l). Small oscillations are those of a Spring; large ones are slower. The course's
/// simplest nonlinear force (I05).
template <class Real>
struct Pendulum {
    Real omega;  ///< angular frequency of small oscillations, rad/s

    /// `omega` in rad/s, zero or more, its square finite. Throws `std::invalid_argument`.
    explicit Pendulum(Real omega_) : omega(not_negative("omega", omega_)) {
        if (!std::isfinite(omega * omega))
            refuse("omega", omega, "small enough that its square is finite");
    }

    /// The angular acceleration −ω² sin x, rad/s².
    Real acceleration(Real x) const { return -omega * omega * std::sin(x); }
    /// ∂a/∂x = −ω² cos x, 1/s², for implicit methods.
    Real slope_x(Real x) const { return -omega * omega * std::cos(x); }

    /// Energy over m l², 1/s²: kinetic ½v² and potential ω²(1 − cos x), zero at rest.
    Real energy(const State<Real>& s) const {
        const Real half = std::sin(s.x / 2);
        return s.v * s.v / 2 + 2 * omega * omega * half * half;
    }
};

}  // namespace timestep
