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
/// ζ = c / (2√(k m)). ζ = 0 swings for ever, ζ = 1 is critical, ζ > 1 does not swing.
template <class Real>
struct DampedSpring {
    Real omega;  ///< angular frequency without damping, rad/s
    Real zeta;   ///< damping ratio, no unit

    /// Whether the constructor takes these parameters.
    [[nodiscard]] static constexpr bool valid(Real omega_, Real zeta_) noexcept {
        using detail::is_finite_parameter;
        return is_finite_parameter(omega_) && omega_ >= 0 && is_finite_parameter(omega_ * omega_) &&
               is_finite_parameter(zeta_) && zeta_ >= 0 && is_finite_parameter(2 * zeta_ * omega_);
    }

    /// `omega` in rad/s and `zeta`, both zero or more; ω² and 2ζω finite.
    /// Throws `std::invalid_argument`.
    constexpr DampedSpring(Real omega_, Real zeta_)
        : omega(not_negative("omega", omega_)), zeta(not_negative("zeta", zeta_)) {
        for_each_number(
            [](auto w, auto z) {
                if (!detail::is_finite_parameter(w * w))
                    refuse("omega", w, "small enough that its square is finite");
                if (!detail::is_finite_parameter(2 * z * w))
                    refuse("zeta", z, "small enough that 2 zeta omega is finite");
            },
            omega, zeta);
    }

    /// A spring of stiffness k, N/m, damping c, N·s/m, and mass m, kg: ω = √(k/m), ζ = c / (2√(k
    /// m)). Throws `std::invalid_argument` unless k and m are above zero and c is zero or more.
    static DampedSpring from_stiffness(Real k, Real c, Real m) {
        using std::sqrt;
        const Real root_k = sqrt(positive("stiffness", k));
        const Real root_m = sqrt(positive("mass", m));
        return DampedSpring(root_k / root_m, not_negative("damping", c) / (root_k * root_m) / 2);
    }

    /// The acceleration −ω² x − 2ζω v, m/s².
    template <class X>
    constexpr X acceleration(const X& x, const X& v) const {
        return -omega * omega * x - 2 * zeta * omega * v;
    }

    constexpr Real slope_x() const { return -omega * omega; }     ///< ∂a/∂x, 1/s²
    constexpr Real slope_v() const { return -2 * zeta * omega; }  ///< ∂a/∂v, 1/s

    /// The exact state `t` seconds after `start`, for every ζ.
    template <class X>
    State<X> exact(const State<X>& start, real_of<X> t) const {
        return zeta < 1 ? swinging(start, t) : creeping(start, t);
    }

private:
    // ζ < 1. With γ = ζω and β = ω√(1 − ζ²), e^(−γt) cos βt and e^(−γt) sin βt solve the equation.
    // The start x₀, v₀ picks the constants: x = e^(−γt) (x₀ cos βt + (v₀ + γx₀) sin βt / β).
    // Written as (1 − ζ)(1 + ζ), 1 − ζ² loses no digits near ζ = 1, and sin βt / β tends to t.
    template <class X>
    State<X> swinging(const State<X>& start, real_of<X> t) const {
        using std::cos, std::exp, std::sin, std::sqrt;
        const Real gamma = zeta * omega;
        const Real beta = omega * sqrt((1 - zeta) * (1 + zeta));
        const auto e = real_of<X>(exp(-gamma * t));
        if (e == 0) return {start.t + t, e * start.x, e * start.v};  // at rest; βt may be infinite
        const auto c = real_of<X>(e * cos(beta * t));
        const auto s = real_of<X>(beta > 0 ? e * sin(beta * t) / beta : e * t);
        const auto gamma_s = real_of<X>(gamma * s), pull = real_of<X>(omega * omega * s);
        const X x = (c + gamma_s) * start.x + s * start.v;
        const X v = (c - gamma_s) * start.v - pull * start.x;
        return {start.t + t, x, v};
    }

    // ζ ≥ 1. Two exponentials e^(−pt) and e^(−qt) solve the equation: p, q = ω (ζ ∓ √(ζ² − 1)).
    // The slow one is written p = ω / (ζ + √(ζ² − 1)), since pq = ω²: nothing cancels for large ζ.
    //     s = (e^(−pt) − e^(−qt)) / (q − p) = e^(−pt) (1 − e^(−(q − p)t)) / (q − p)
    // is what a push of v₀ = 1 does. By expm1 it keeps its digits as q − p → 0, where it tends to
    // t e^(−pt), the answer at ζ = 1. No cosh, which overflows long before its e^(−γt) makes up for
    // it. The start weighs in as x = (e^(−pt) + p s) x₀ + s v₀; no term is below zero when
    // x₀ and v₀ are not.
    /// [creeping]
    template <class X>
    State<X> creeping(const State<X>& start, real_of<X> t) const {
        using std::exp, std::expm1, std::sqrt;
        const Real root = sqrt(zeta - 1) * sqrt(zeta + 1);
        const Real p = omega / (zeta + root);
        const Real q = zeta * omega + omega * root;
        const Real gap = 2 * omega * root;  // q − p
        const auto e_p = real_of<X>(exp(-p * t));
        const auto e_q = real_of<X>(exp(-q * t));
        const auto s = real_of<X>(gap > 0 ? -e_p * expm1(-gap * t) / gap : e_p * t);
        const auto p_s = real_of<X>(p * s), pull = real_of<X>(omega * omega * s);
        const X x = (e_p + p_s) * start.x + s * start.v;
        const X v = (e_q - p_s) * start.v - pull * start.x;
        return {start.t + t, x, v};
    }
    /// [creeping]
};

}  // namespace timestep
