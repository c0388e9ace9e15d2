#pragma once
/// \file
/// The half-step Jacobian for any spin and any sequence of steps: it keeps the energy and |L|.

#include <algorithm>
#include <cmath>

#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// The half-step Jacobian, in substeps if it might be singular, and scaled back to the energy that
/// the step began with. Unscaled, it keeps E/Δ and |L|²/Δ, where Δ is its determinant for the
/// component of ω about the intermediate axis alone, over that at rest. So |L|²/E stays in every
/// step, and the scaling restores both to roundoff: ω stays on the true curve at any spin, with
/// varying steps, and between impulses. Only the time at which ω reaches each point of the curve is
/// off, by order two.
///
/// A body that needs more than `most` substeps gets `most` of them and circles on its curve too
/// slowly: safe, but not accurate. If (hω)² is too large for a number, the step may return NaN.
struct CalmHalfStep : PassiveIfSymmetric<CalmHalfStep> {
    static constexpr const char* name = "calm half-step";  ///< for tables and keys
    static constexpr int order = 2;                        ///< of the error of ω after a whole run
    using PassiveIfSymmetric<CalmHalfStep>::step;
    static constexpr double angle =
        0.5;  ///< the angle, rad, by which ω may circle in a substep, from the step's first ω
    static constexpr int most = 32;  ///< the largest number of substeps

    // The angle by which ω circles in a step: with p_x = |a_y a_z| θ_x² and so on round, θ = hω,
    // and r the axis of the intermediate moment, the exact motion circles by the root of the larger
    // of p_r + p_i and p_r + p_j. Both stay, and the sum of all three, which is used here, is at
    // least as large. And Δ = 1 − p_r/4, so it is above 15/16 in substeps for which that sum is
    // below ¼. In these the substeps keep both over Δ, and p_r is at most ¼ on the way, too: p_r/Δ
    // is at most ¼/(15/16). The sum itself is at most (¼ + ¼)/(15/16) = 8/15 there: reckoned with
    // the ω on the way, a substep circles by up to 0.73 and not 0.5.
    //
    // The scaling, by √(E₁/E₂) = 1 + share: the share has all its digits, a root near one would
    // have lost them, always to the same side, and in float 1 % of the energy an hour.
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    /// [step]
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        const Vector3<Real>& a = inertia.ratio;
        const Vector3<Real> aa(a.y() * a.z(), a.z() * a.x(), a.x() * a.y());
        const Real circled2 = dot(aa.cwiseAbs(), (h * omega).cwiseAbs2());
        Real part = h;
        int parts = 1;
        if (circled2 > Real(angle * angle)) {
            const Real wanted = std::ceil(std::sqrt(circled2) / Real(angle));
            part = h / wanted;
            parts = int(std::min(wanted, Real(most)));
        }
        Vector3<Real> w = omega;
        for (int n = 0; n < parts; ++n) w = half_step_jacobian.step(inertia, w, part);

        const auto energy = [&](const Vector3<Real>& spin) {
            return dot(inertia.unit, (part * spin).cwiseAbs2());
        };
        const Real E1 = energy(omega), E2 = energy(w);
        const Real share = E2 > 0 ? (E1 - E2) / (E2 + std::sqrt(E1 * E2)) : 0;
        return w + share * w;
    }
    /// [step]
};

inline constexpr CalmHalfStep calm_half_step;  ///< the method as a value

}  // namespace timestep
