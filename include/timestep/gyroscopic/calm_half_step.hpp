#pragma once
/// \file
/// The half-step Jacobian for any spin and any steps: it keeps the energy and |L|.

#include <algorithm>
#include <cmath>

#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// The half-step Jacobian, in substeps where it might be singular, and scaled back to the energy
/// that the step began with. Unscaled it keeps E/Δ and |L|²/Δ, where Δ is its determinant for the
/// component of ω about the intermediate moment's axis alone, over that at rest. So |L|²/E stays in
/// every step, and the scaling brings both back, to roundoff: ω stays on the true curve at any
/// spin, when steps vary, and from one impulse to the next. What is off is only when it is where,
/// by order two.
///
/// A body that asks for more than `most` substeps gets that many, and circles on its curve too
/// slowly: safe, and not right. Where (hω)² is too large for a number it may give back NaN.
struct CalmHalfStep {
    static constexpr const char* name = "calm half-step";  ///< for tables and keys
    static constexpr int order = 2;                        ///< of the error of ω after a whole run
    static constexpr double angle =
        0.5;  ///< by which ω may circle in a substep, reckoned with the step's first ω; rad
    static constexpr int most = 32;  ///< substeps

    // How far does ω circle in a step? With p_x = |a_y a_z| θ_x² and so on round, θ = hω, and r the
    // axis of the intermediate moment, the exact motion circles by the root of the larger of p_r +
    // p_i and p_r + p_j. Both stay, and the sum of all three, which we take, is at least as large.
    // And Δ = 1 − p_r/4, so it is above 15/16 in substeps for which that sum is below ¼. In these
    // the substeps keep both over Δ, and p_r is at most ¼ on the way, too: p_r/Δ is at most
    // ¼/(15/16). The sum itself is at most (¼ + ¼)/(15/16) = 8/15 there: reckoned with the ω on the
    // way, a substep circles by up to 0.73 and not 0.5.
    //
    // The scaling, by √(E₁/E₂) = 1 + share: the share has all its digits, a root near one would
    // have lost them, always to the same side, and in float 1 % of the energy an hour.
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    /// [step]
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                                       const Vector3<Real>& omega, Real h) const noexcept {
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

    /// The same where two moments are equal: the passive step, which keeps energy and |L| there.
    template <class Real>
    TIMESTEP_INLINE Vector3<Real> step(const SymmetricInertia<Real>& inertia,
                                       const Vector3<Real>& omega, Real h) const noexcept {
        return passive_gyroscopic.step(inertia, omega, h);
    }

    /// The same with another odd axis.
    template <Axis axis, class Real>
    TIMESTEP_INLINE Vector3<Real> step(const SymmetricAbout<axis, Real>& inertia,
                                       const Vector3<Real>& omega, Real h) const noexcept {
        return inertia.from_z(step(inertia.about_z, inertia.to_z(omega), h));
    }

    /// The same in any axes: there and back by way of the principal ones.
    template <class Real>
    Vector3<Real> step(const FullInertia<Real>& inertia, const Vector3<Real>& omega,
                       Real h) const noexcept {
        const Vector3<Real> turned = in_body(inertia.axes, omega);
        return in_world(inertia.axes, step(inertia.principal, turned, h));
    }
};

inline constexpr CalmHalfStep calm_half_step;  ///< the method as a value

}  // namespace timestep
