#pragma once
/// \file
/// Adams–Bashforth of order two, as flight simulators take it: the slope before counts, too.

#include "buss.hpp"

namespace timestep {

/// x₂ = x₁ + h (3/2 ẋ₁ − 1/2 ẋ₀), for the spin and for the orientation's four numbers, which are then
/// scaled back to length one. One slope a step, since the one before is remembered. What is remembered is
/// wrong after an impulse, and with another step: then, and at the start, it takes one of Buss's steps.
template <class Real>
class AdamsBashforthSpin {
public:
    static constexpr const char* name = "Adams-Bashforth 2";  ///< for tables and keys
    static constexpr int order = 2;                           ///< of the error after a whole run

    /// One step of `h` seconds.
    SpinState<Real> step(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s1, Real h) {
        const bool goes_on = h == h_ && s1.omega == last_.omega && s1.q.coeffs() == last_.q.coeffs();
        const Slope slope = slope_of(inertia, s1);
        last_ = goes_on ? extrapolated(s1, slope, h) : buss_2.step(inertia, s1, h);
        before_ = slope, h_ = h;
        return last_;
    }

private:
    struct Slope {
        Eigen::Matrix<Real, 4, 1> q;
        Vector3<Real> omega;
    };
    static Slope slope_of(const PrincipalInertia<Real>& inertia, const SpinState<Real>& s) {
        const Quaternion<Real> spin(0, s.omega.x(), s.omega.y(), s.omega.z());
        return {(s.q * spin).coeffs() / 2,
                -s.omega.cross(Vector3<Real>(inertia.unit.cwiseProduct(s.omega))).cwiseQuotient(inertia.unit)};
    }
    /// [step]
    SpinState<Real> extrapolated(const SpinState<Real>& s1, const Slope& slope, Real h) const {
        Quaternion<Real> q;
        q.coeffs() = s1.q.coeffs() + h / 2 * (3 * slope.q - before_.q);
        const Vector3<Real> omega = s1.omega + h / 2 * (3 * slope.omega - before_.omega);
        return {s1.t + h, q.normalized(), omega};
    }
    /// [step]

    Slope before_{Eigen::Matrix<Real, 4, 1>::Zero(), Vector3<Real>::Zero()};
    SpinState<Real> last_{0, Quaternion<Real>::Identity(), Vector3<Real>::Zero()};
    Real h_ = 0;  // no step yet
};

}  // namespace timestep
