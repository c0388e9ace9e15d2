#pragma once
/// \file
/// The mass on a spring, on which the course tries every method first.

#include <cmath>

#include <timestep/checks.hpp>
#include <timestep/forces.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// An undamped spring, a = −ω² x, with position measured from the equilibrium (N13, N14).
///
/// Dividing m ẍ = −k x by the mass leaves one parameter, ω = √(k/m). The position may be a number
/// or a vector: in 3D it is a spring that pulls to the origin with zero rest length (I03).
template <class Real>
struct Spring {
    Real omega;  ///< angular frequency, rad/s

    /// Whether the constructor takes this frequency.
    [[nodiscard]] static constexpr bool valid(Real omega_) noexcept {
        return omega_ >= 0 && detail::is_finite_parameter(omega_) &&
               detail::is_finite_parameter(omega_ * omega_);
    }

    /// `omega` in rad/s, zero or more, its square finite. Throws `std::invalid_argument`.
    explicit constexpr Spring(Real omega_) : omega(not_negative("omega", omega_)) {
        for_each_number(
            [](auto w) {
                if (!detail::is_finite_parameter(w * w))
                    refuse("omega", w, "small enough that its square is finite");
            },
            omega);
    }

    /// A spring of stiffness k, N/m, zero or more, and mass m, kg, above zero: ω = √(k/m). The
    /// roots are taken first, because k/m may overflow when ω does not. Throws
    /// `std::invalid_argument`.
    static Spring from_stiffness(Real k, Real m) {
        using std::sqrt;
        return Spring(sqrt(not_negative("stiffness", k)) / sqrt(positive("mass", m)));
    }

    /// The acceleration −ω² x, m/s².
    template <class X>
    constexpr X acceleration(const X& x) const {
        return -omega * omega * x;
    }

    /// ∂a/∂x = −ω², 1/s², a constant.
    constexpr Real slope_x() const { return -omega * omega; }

    /// Energy per unit of mass, m²/s²: kinetic ½v² and stored ½ω²x².
    template <class X>
    real_of<X> energy(const State<X>& s) const {
        if constexpr (is_number<X>)
            return (s.v * s.v + omega * omega * s.x * s.x) / 2;
        else
            return (dot(s.v, s.v) + omega * omega * dot(s.x, s.x)) / 2;
    }

    /// The exact state `t` seconds after `start`: x₀ cos ωt + (v₀/ω) sin ωt and its derivative. The
    /// result has the number type of the state, which may differ from the spring's.
    template <class X>
    State<X> exact(const State<X>& start, real_of<X> t) const {
        using std::cos, std::sin;
        const auto c = real_of<X>(cos(omega * t));
        const auto s = real_of<X>(sin(omega * t));
        const auto s_over_omega = real_of<X>(omega > 0 ? s / omega : t);  // its limit as ω → 0
        const auto omega_s = real_of<X>(omega * s);
        return {start.t + t, c * start.x + s_over_omega * start.v, c * start.v - omega_s * start.x};
    }
};

}  // namespace timestep
