#pragma once
/// \file
/// A rotating body: its state, and one step of it with any treatment of the gyroscopic torque.

#include <type_traits>

#include <timestep/inline.hpp>
#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// \cond
namespace detail {
template <class Inertia, class Real>
inline constexpr bool one_real = std::is_same_v<typename Inertia::Scalar, Real>;
}
/// \endcond

/// The state of a body that rotates about its centre of mass, with ω in WORLD coordinates.
/// SpinState holds ω in body coordinates. They are two types, so the compiler tells them apart;
/// in_body() and in_world() convert.
template <class Real>
struct RigidState {
    using Scalar = Real;  ///< the real number type

    Real t;               ///< time, s
    Quaternion<Real> q;   ///< orientation: q v q* is in world coordinates what v is in the body's
    Vector3<Real> omega;  ///< angular velocity in world coordinates, rad/s
};

/// Whether every part of the state is a finite number and the quaternion is not zero.
template <class Real>
[[nodiscard]] bool is_finite(const RigidState<Real>& s) {
    const auto& q = s.q;
    return std::isfinite(s.t) && is_finite(q.coeffs()) && is_finite(s.omega) &&
           (q.w() != 0 || q.x() != 0 || q.y() != 0 || q.z() != 0);
}

/// The angular momentum in world coordinates, kg m²/s.
template <class Inertia, class Real>
Vector3<Real> angular_momentum(const Inertia& inertia, const RigidState<Real>& s) {
    const Matrix3<Real> R = s.q.toRotationMatrix();
    return in_world(R, inertia.momentum(in_body(R, s.omega)));
}

/// The kinetic energy of the rotation, J.
template <class Inertia, class Real>
Real kinetic_energy(const Inertia& inertia, const RigidState<Real>& s) {
    return kinetic_energy(inertia, Vector3<Real>(s.q.conjugate() * s.omega));
}

/// The change of the angular velocity, rad/s, by the gyroscopic torque in `h` seconds. ω and its
/// change are in world coordinates; `R` is the orientation as a rotation matrix, which engines keep
/// beside the quaternion. `Gyroscopic` solves in body coordinates, where the inertia is constant
/// (N47). For a body without a gyroscopic torque nothing is computed (N41).
/// [change]
template <class Gyroscopic, class Inertia, class Real>
TIMESTEP_INLINE Vector3<Real> gyroscopic_change(const Gyroscopic& solver, const Inertia& inertia,
                                                const Matrix3<Real>& R, const Vector3<Real>& omega,
                                                Real h) {
    static_assert(
        detail::one_real<Inertia, Real>,
        "timestep: the inertia and the state hold one kind of number: both float, or both double");
    if constexpr (!Inertia::gyroscopic) {
        return Vector3<Real>::Zero();
    } else {
        const Vector3<Real> body = in_body(R, omega);
        const Vector3<Real> after = solver.step(inertia, body, h);
        return in_world(R, Vector3<Real>(after - body));
    }
}
/// [change]

/// The angular velocity, rad/s in world coordinates, after `h` seconds of the gyroscopic torque;
/// `R` is the orientation as a rotation matrix.
// The rounded R is not an exact rotation. Only the change is rotated back: if all of ω were, step
// after step, the energy would creep, in `float` by several percent per hour.
/// [gyroscopic]
template <class Gyroscopic, class Inertia, class Real>
TIMESTEP_INLINE Vector3<Real> after_gyroscopic_torque(const Gyroscopic& solver,
                                                      const Inertia& inertia,
                                                      const Matrix3<Real>& R,
                                                      const Vector3<Real>& omega, Real h) {
    if constexpr (!Inertia::gyroscopic)
        return omega;
    else
        return omega + gyroscopic_change(solver, inertia, R, omega, h);
}
/// [gyroscopic]

/// The angular velocity, rad/s in world coordinates, after `h` seconds of the gyroscopic torque;
/// `q` is the orientation.
template <class Gyroscopic, class Inertia, class Real>
TIMESTEP_INLINE Vector3<Real> after_gyroscopic_torque(const Gyroscopic& solver,
                                                      const Inertia& inertia,
                                                      const Quaternion<Real>& q,
                                                      const Vector3<Real>& omega, Real h) {
    if constexpr (!Inertia::gyroscopic)
        return omega;
    else
        return after_gyroscopic_torque(solver, inertia, Matrix3<Real>(q.toRotationMatrix()), omega,
                                       h);
}

/// One step of `h` seconds of a body without an external torque.
template <class Gyroscopic, class Inertia, class Real>
[[nodiscard]] RigidState<Real> step_rotation(const Gyroscopic& solver, const Inertia& inertia,
                                             const RigidState<Real>& s1, Real h) {
    static_assert(
        detail::one_real<Inertia, Real>,
        "timestep: the inertia and the state hold one kind of number: both float, or both double");
    const Vector3<Real> omega2 = after_gyroscopic_torque(solver, inertia, s1.q, s1.omega, h);
    return {s1.t + h, rotated(s1.q, omega2, h), omega2};
}

// Torques add, so each may be treated in its own way (N46): ω changes by I⁻¹T h for the external
// torque, explicitly, and then by the gyroscopic torque, as the solver treats it. Treating them one
// after the other costs an error of order h² per step, which a method of order one makes anyway.
/// One step of `h` seconds of a body under an external `torque`, N m in world coordinates.
/// [driven]
template <class Gyroscopic, class Inertia, class Real>
[[nodiscard]] RigidState<Real> step_rotation(const Gyroscopic& solver, const Inertia& inertia,
                                             const RigidState<Real>& s1,
                                             const Vector3<Real>& torque, Real h) {
    static_assert(
        detail::one_real<Inertia, Real>,
        "timestep: the inertia and the state hold one kind of number: both float, or both double");
    const Vector3<Real> in_body = s1.q.conjugate() * torque;
    const Vector3<Real> push = s1.q * inertia.velocity(in_body);
    const Vector3<Real> driven = s1.omega + h * push;
    return step_rotation(solver, inertia, RigidState<Real>{s1.t, s1.q, driven}, h);
}
/// [driven]

/// World axes about which a body may not rotate, for characters that must not topple: a mask that
/// is applied after the step. (An infinite moment instead would put ∞ − ∞ into every solver.)
template <class Real>
struct LockedAxes {
    Vector3<Real> free = Vector3<Real>::Ones();  ///< 1 where the body may rotate, 0 where not
    /// `omega` without its locked components.
    Vector3<Real> operator()(const Vector3<Real>& omega) const { return free.cwiseProduct(omega); }
};

}  // namespace timestep
