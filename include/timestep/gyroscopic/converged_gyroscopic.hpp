#pragma once
/// \file
/// Implicit Euler on the gyroscopic torque, solved to the end.

#include <algorithm>
#include <cmath>
#include <limits>

#include <timestep/rigid/symmetric_about.hpp>
#include <timestep/rigid/solve3.hpp>

namespace timestep {

/// The ω₂ with I(ω₂ − ω₁) + h ω₂ × Iω₂ = 0, to the last digit (N48). It never adds energy (N51),
/// damps as much as the talk's single iteration while that one is stable, and costs several times
/// as much. The course uses it to separate Newton–Raphson's faults from implicit Euler's.
///
/// For long steps several ω₂ solve this equation. The step returns the root that is ω₁ at h = 0 and
/// changes without a jump as h grows. There is one for every h; for long steps it points along the
/// axis that the exact motion circles. Returns NaN if (hω)² is too large for a number.
struct ConvergedGyroscopic : InOtherAxes<ConvergedGyroscopic> {
    static constexpr const char* name = "implicit, converged";  ///< for tables and keys
    static constexpr int order = 1;                             ///< of the error after a whole run
    using InOtherAxes<ConvergedGyroscopic>::step;

    // In y = √I ω (energy ½|y|²) the equation is y₂ + h g∘(y₂y₃, y₃y₁, y₁y₂) = y₁ with
    // g = (I₃ − I₂, I₁ − I₃, I₂ − I₁)/√(I₁I₂I₃). (Below, U are the moments with the product one.)
    // No energy is added: g sums to zero, so the middle term is at right angles to y₂, and
    // |y₂|² = y₂·y₁ ≤ |y₂| |y₁|.
    /// One step of `h` seconds; `omega` in body coordinates, rad/s. Calls `iterated()` after each
    /// iteration.
    template <class Real, class Iterated>
    [[nodiscard]] Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                                     const Vector3<Real>& omega, Real h,
                                     const Iterated& iterated) const {
        const Vector3<Real>& U = inertia.unit;
        const Vector3<Real> g = U.cwiseProduct(inertia.ratio);
        const Vector3<Real> r = U.cwiseSqrt();
        const Vector3<Real> y1 = r.cwiseProduct(omega);
        return follow(Vector3<Real>(h * g), y1, iterated).cwiseQuotient(r);
    }
    /// One step of `h` seconds; `omega` in body coordinates, rad/s.
    template <class Real>
    [[nodiscard]] Vector3<Real> step(const PrincipalInertia<Real>& inertia,
                                     const Vector3<Real>& omega, Real h) const {
        return step(inertia, omega, h, [] {});
    }

    /// One step of `h` seconds of a body with two equal moments; `omega` in body coordinates,
    /// rad/s. The equation is linear there, so one iteration is the solution.
    template <class Real>
    [[nodiscard]] Vector3<Real> step(const SymmetricInertia<Real>& inertia,
                                     const Vector3<Real>& omega, Real h) const {
        const Real angle = h * inertia.precession_ratio * omega.z();
        const Real share = 1 / (1 + angle * angle);
        return {share * (omega.x() - angle * omega.y()), share * (omega.y() + angle * omega.x()),
                omega.z()};
    }

private:
    // For long steps there are several roots, and Newton–Raphson from y₁ may find any of them. Ours
    // is followed from h = 0, where it is y₁, as h grows: each stretch starts from the root of the
    // one before, is halved if it fails, and doubled if not. The result is NaN if a stretch changes
    // no digit, or after as many stretches as would halve 1 to the smallest number and double it
    // back, twice.
    //
    // Our root can be recognised. The exact motion circles the axis k of the least or of the
    // largest moment, and along that one our root keeps the sign of y₁ and at least half of it; no
    // other root does. For let y be a root, a = y₁, and w = h times the product of y's parts. Then
    //     yᵢ² − aᵢ yᵢ + gᵢ w = 0,  yᵢ = aᵢ/2 ± √(aᵢ²/4 − gᵢ w),  h = w / product.
    // At h = 0 all three have the plus and w = 0. Then w goes up or down until one of the square
    // roots is zero, takes the minus there, and comes back, through zero, to the end on the other
    // side. Two gᵢ have one sign, those of the least and the largest moment; the square root with
    // the larger aᵢ²/|gᵢ| never gets to zero. Its i is k (it is where L² − 2E I₂ says), so k keeps
    // the plus. On the way d ln h / d ln w = 1 + Σ (aᵢ − yᵢ)/(2yᵢ − aᵢ) is nowhere zero: h rises
    // to infinity and meets each value once. And all other roots with the plus for k lie on the way
    // for h < 0.
    template <class Real, class Iterated>
    static Vector3<Real> follow(const Vector3<Real>& hg, const Vector3<Real>& y1,
                                const Iterated& iterated) {
        const int axis = circled(hg, y1);
        Vector3<Real> y = y1;
        Real done = 0, stretch = 1;
        int stretches = 4 * std::numeric_limits<Real>::max_exponent;
        while (done < 1) {
            const Real next = std::min(Real(1), done + stretch);
            if (next == done || --stretches == 0)
                return Vector3<Real>::Constant(std::numeric_limits<Real>::quiet_NaN());
            Vector3<Real> root = y;
            if (newton(Vector3<Real>(next * hg), y1, root, iterated) &&
                !(root[axis] / y1[axis] < Real(0.5))) {
                y = root;
                done = next;
                stretch *= 2;
            } else {
                stretch /= 2;
            }
        }
        return y;
    }

    // The axis that the exact motion circles. The intermediate moment has the largest |g|, as Σg =
    // 0.
    template <class Real>
    static int circled(const Vector3<Real>& hg, const Vector3<Real>& y1) {
        const Vector3<Real> root = hg.cwiseAbs().cwiseSqrt();
        int middle;
        root.maxCoeff(&middle);
        const int i = (middle + 1) % 3, j = (middle + 2) % 3;
        return std::abs(y1[i]) * root[j] > std::abs(y1[j]) * root[i] ? i : j;
    }

    // Newton–Raphson from `y`; returns whether it has found the root. One more iteration, after the
    // residual is down to roundoff, removes the rest.
    template <class Real, class Iterated>
    static bool newton(const Vector3<Real>& hg, const Vector3<Real>& y1, Vector3<Real>& y,
                       const Iterated& iterated) {
        const Real roundoff = 8 * std::numeric_limits<Real>::epsilon() * y1.cwiseAbs().maxCoeff();
        bool found = false;
        for (int iteration = 0; iteration < 12; ++iteration) {
            const Vector3<Real> pairs(y.y() * y.z(), y.z() * y.x(), y.x() * y.y());
            const Vector3<Real> residual = y - y1 + hg.cwiseProduct(pairs);
            if (found) return residual.cwiseAbs().maxCoeff() <= roundoff;
            found = residual.cwiseAbs().maxCoeff() <= roundoff;
            const Vector3<Real> column1(1, hg.y() * y.z(), hg.z() * y.y());
            const Vector3<Real> column2(hg.x() * y.z(), 1, hg.z() * y.x());
            const Vector3<Real> column3(hg.x() * y.y(), hg.y() * y.x(), 1);
            y -= solve3(column1, column2, column3, residual);
            iterated();
        }
        return false;
    }
};

inline constexpr ConvergedGyroscopic converged_gyroscopic;  ///< the method as a value

}  // namespace timestep
