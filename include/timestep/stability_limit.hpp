#pragma once
/// \file
/// The longest stable step: the largest ωh for which a damped spring does not grow, in closed form,
/// for every method and damping ratio ζ (N23, N25, N33).
///
/// A step is a 2×2 matrix. Its eigenvalues are the roots of λ² − Tλ + D with the trace T and the
/// determinant D, and both lie in the unit disk when (Jury's conditions)
///     D ≤ 1,    1 − T + D ≥ 0,    1 + T + D ≥ 0.
/// The second holds for every method here, the first is broken by an oscillation that grows, the
/// third by a state that flips over and over. Below, s = ωh, positions are measured in x and
/// velocities in ω x.
///
/// ζ is that of a DampedSpring: finite, and zero or more. It is not checked again here; for a
/// negative ζ or a NaN the results mean nothing.

#include <cmath>
#include <complex>
#include <limits>

#include <timestep/multipliers.hpp>

namespace timestep {

/// The largest stable ωh, and the formula it comes from.
struct StabilityLimit {
    double value;         ///< rad; infinite if every step is stable
    const char* formula;  ///< the formula, as text
};

/// \cond
namespace detail {
inline constexpr StabilityLimit no_limit{std::numeric_limits<double>::infinity(), "no limit"};

// Of ζ ± √(ζ² − 1) the larger: the fast one of the two decays of an overdamped spring, over ω.
inline double fast_decay(double zeta) { return zeta + std::sqrt(zeta - 1) * std::sqrt(zeta + 1); }

// The one root of f, which is below zero at 0 and rises through it once.
template <class Function>
double rising_root(const Function& f) {
    double low = 0, high = 1;
    while (f(high) < 0) low = high, high *= 2;
    for (int i = 0; i < 200 && low < high; ++i) {
        const double middle = low + (high - low) / 2;
        if (middle == low || middle == high) break;
        (f(middle) < 0 ? low : high) = middle;
    }
    return low;
}
}  // namespace detail
/// \endcond

/// Explicit Euler: T = 2 − 2ζs, D = 1 − 2ζs + s². An oscillation grows from D = 1 on, s = 2ζ.
/// Beyond ζ = 1 nothing swings; the fast decay flips from 1 + T + D = 4 − 4ζs + s² = 0 on.
inline StabilityLimit stability_limit(const ExplicitEuler&, double zeta) {
    if (zeta <= 1) return {2 * zeta, "2ζ"};
    return {2 / detail::fast_decay(zeta), "2 / (ζ + √(ζ² − 1))"};
}

/// [semi-implicit]
/// Semi-implicit Euler: T = 2 − 2ζs − s², D = 1 − 2ζs, and so
/// 1 + T + D = 4 − 4ζs − s², which must not be negative.
inline StabilityLimit stability_limit(const SemiImplicitEuler&, double zeta) {
    return {2 / (std::hypot(1, zeta) + zeta), "2 (√(1 + ζ²) − ζ)"};
}
/// [semi-implicit]

/// With the damping at the new velocity the sign of ζ turns: T = (2 + 2ζs − s²)/(1 + 2ζs),
/// D = 1/(1 + 2ζs), and 1 + T + D = 0 where 4 + 4ζs = s².
inline StabilityLimit stability_limit(const SemiImplicitEulerNewDamping&, double zeta) {
    return {2 * (std::hypot(1, zeta) + zeta), "2 (√(1 + ζ²) + ζ)"};
}

/// The constant-acceleration step: T = 2 − 2ζs − s²/2, D = 1 − 2ζs + s²/2. It swings too far from s
/// = 4ζ on, and flips from 1 + T + D = 4 − 4ζs = 0 on.
inline StabilityLimit stability_limit(const ConstantAcceleration&, double zeta) {
    if (zeta <= 0.5) return {4 * zeta, "4ζ"};
    return {1 / zeta, "1/ζ"};
}

// Without a damper the Verlet methods are semi-implicit Euler; with one they do not step at all.
/// Plain Verlet, for ζ = 0.
inline StabilityLimit stability_limit(const Verlet&, double) { return {2, "2"}; }
/// Velocity Verlet, for ζ = 0.
inline StabilityLimit stability_limit(const VelocityVerlet&, double) { return {2, "2"}; }
/// Leapfrog, for ζ = 0.
inline StabilityLimit stability_limit(const Leapfrog&, double) { return {2, "2"}; }

/// \cond
namespace detail {
// The methods of two stages multiply a decay by R(z) = 1 + z + z²/2, with z = h times its rate,
// −s (ζ ± i √(1 − ζ²)). With |z| = s and Re z = −ζs,
//     |R|² − 1 = s (s³/4 − ζs² + 2ζ²s − 2ζ),
// and what is in the brackets rises with s, as its slope has no zero. A fast decay is real: R ≤ 1
// for −2 ≤ z.
inline StabilityLimit two_stages_limit(double zeta) {
    if (zeta > 1) return {2 / fast_decay(zeta), "2 / (ζ + √(ζ² − 1))"};
    return {rising_root(
                [&](double s) { return ((s / 4 - zeta) * s + 2 * zeta * zeta) * s - 2 * zeta; }),
            "the s = ωh with s³/4 − ζs² + 2ζ²s = 2ζ"};
}
}  // namespace detail
/// \endcond
/// The midpoint method, R(z) = 1 + z + z²/2.
inline StabilityLimit stability_limit(const Midpoint&, double zeta) {
    return detail::two_stages_limit(zeta);
}
/// Heun's method, which has the R(z) of the midpoint method.
inline StabilityLimit stability_limit(const Heun&, double zeta) {
    return detail::two_stages_limit(zeta);
}

/// RK4: |R(z)| = 1 for R(z) = 1 + z + z²/2 + z³/6 + z⁴/24, along the ray of z = −s (ζ + i √(1 −
/// ζ²)), or of the fast decay. It is left once. Expanded, |R|² − 1 loses the common factor s, by
/// which the rest keeps its digits for small s.
inline StabilityLimit stability_limit(const RungeKutta4&, double zeta) {
    if (zeta >= 1) {
        // R = 1 again at the z with 1 + z/2 + z²/6 + z³/24 = 0, some −2.785.
        const double z = detail::rising_root(
            [](double s) { return ((s / 24 - 1.0 / 6) * s + 1.0 / 2) * s - 1; });
        return {z / detail::fast_decay(zeta), "2.785 / (ζ + √(ζ² − 1))"};
    }
    // |R|² is the sum of all zʲ z̄ᵏ / (j! k!), and Re zʲ z̄ᵏ = s^(j+k) cos (j − k)φ with cos φ = −ζ.
    const double c1 = -zeta, c2 = 2 * c1 * c1 - 1, c3 = 2 * c1 * c2 - c1, c4 = 2 * c1 * c3 - c2;
    const double sum[] = {2 * c1,           1 + c2,
                          c1 + c3 / 3,      1.0 / 4 + c2 / 3 + c4 / 12,
                          c1 / 6 + c3 / 12, 1.0 / 36 + c2 / 24,
                          c1 / 72,          1.0 / 576};
    return {detail::rising_root([&](double s) {
                double value = 0;
                for (int i = 7; i >= 0; --i) value = value * s + sum[i];
                return value;
            }),
            "the s = ωh at which |1 + z + z²/2 + z³/6 + z⁴/24| = 1"};
}

/// Implicit Euler: D = 1/(1 + 2ζs + s²). There is no limit.
inline StabilityLimit stability_limit(const ImplicitEuler&, double) { return detail::no_limit; }
/// Implicit midpoint: no limit either, as |R(z)| = |1 + z/2|/|1 − z/2| ≤ 1 left of the imaginary
/// axis.
inline StabilityLimit stability_limit(const ImplicitMidpoint&, double) { return detail::no_limit; }
/// BDF2: no limit. Its factor R solves (3 − 2z) R² − 4R + 1 = 0, so z = (3 − 4/R + 1/R²)/2; on the
/// unit circle, R = e^(iθ), Re z = (1 − cos θ)² ≥ 0. So left of the imaginary axis no factor is on
/// the circle, and both stay inside, where they are for z → −∞. (Dahlquist's theorem is another: of
/// the methods over several steps that have no limit none is of an order above two.)
inline StabilityLimit stability_limit(const Bdf2&, double) { return detail::no_limit; }

/// Any method without a formula of its own: the shortest step that grows, found by search.
/// Multipliers above 1 by less than 1e-14 are roundoff.
template <class Method>
StabilityLimit stability_limit(const Method& method, double zeta) {
    const auto stays = [&, damping = static_cast<long double>(zeta)](double s) {
        for (const auto& multiplier :
             detail::multipliers(method, damping, static_cast<long double>(s)))
            if (!(std::abs(multiplier) <= 1 + 1e-14L)) return false;
        return true;
    };
    double low = 0;
    for (double s = 1e-5 / (1 + zeta); s < 1e6; low = s, s *= 1.02) {
        if (stays(s)) continue;
        for (double high = s; low > 0 && high > low * (1 + 1e-12);) {
            const double middle = (low + high) / 2;
            (stays(middle) ? low : high) = middle;
        }
        return {low, "the shortest step found to grow"};
    }
    return detail::no_limit;
}

/// Whether a scene blows up.
enum class Verdict {
    stable,             ///< it stays bounded
    grows,              ///< it grows without bound
    too_close_to_call,  ///< within a thousandth of the boundary: no stiffness is known better than
                        ///< that; or the growth is lost in roundoff
    refused,            ///< the method cannot step this scene at all
    not_proven          ///< it may stay or grow: what is known of the scene does not decide it
};

/// The verdict as text.
inline const char* words(Verdict verdict) {
    switch (verdict) {
        case Verdict::stable:
            return "stable";
        case Verdict::grows:
            return "grows";
        case Verdict::too_close_to_call:
            return "too close to call";
        case Verdict::not_proven:
            return "not proven";
        default:
            return "refused";
    }
}

/// The verdict for `value` beside the stability `limit`.
inline Verdict verdict(double value, double limit) {
    return value < 0.999 * limit   ? Verdict::stable
           : value > 1.001 * limit ? Verdict::grows
                                   : Verdict::too_close_to_call;
}

}  // namespace timestep
