#pragma once
/// \file
/// Angular velocities with their axes in the type, for engines, which use both.

#include <utility>

#include <timestep/rigid/body.hpp>

namespace timestep {

/// ω in the body's axes, rad/s. The chapters use a bare vector and name its axes in words; this
/// type holds the three numbers and converts to a bare vector only by its member.
template <class Real>
struct OmegaBody {
    Vector3<Real> in_the_body;  ///< the numbers
    /// Explicit: a bare vector does not convert by chance.
    explicit OmegaBody(Vector3<Real> numbers) : in_the_body(std::move(numbers)) {}
};
/// ω in the world's axes, rad/s, as engines keep it.
template <class Real>
struct OmegaWorld {
    Vector3<Real> in_the_world;  ///< the numbers
    /// Explicit: a bare vector does not convert by chance.
    explicit OmegaWorld(Vector3<Real> numbers) : in_the_world(std::move(numbers)) {}
};

/// ω in the body's axes, for a body of orientation `q`.
template <class Real>
TIMESTEP_INLINE OmegaBody<Real> in_body(const Quaternion<Real>& q, const OmegaWorld<Real>& omega) {
    return OmegaBody<Real>(in_body(Matrix3<Real>(q.toRotationMatrix()), omega.in_the_world));
}
/// ω in the world's axes, for a body of orientation `q`.
template <class Real>
TIMESTEP_INLINE OmegaWorld<Real> in_world(const Quaternion<Real>& q, const OmegaBody<Real>& omega) {
    return OmegaWorld<Real>(in_world(Matrix3<Real>(q.toRotationMatrix()), omega.in_the_body));
}

/// ω after `h` seconds of the gyroscopic torque, as `solver` treats it.
template <class Gyroscopic, class Inertia, class Real>
TIMESTEP_INLINE OmegaBody<Real> after_gyroscopic_torque(const Gyroscopic& solver,
                                                        const Inertia& inertia,
                                                        const OmegaBody<Real>& omega, Real h) {
    if constexpr (!Inertia::gyroscopic)
        return omega;
    else
        return OmegaBody<Real>(solver.step(inertia, omega.in_the_body, h));
}
/// ω in the world after `h` seconds of the gyroscopic torque, for a body of orientation `q`.
template <class Gyroscopic, class Inertia, class Real>
TIMESTEP_INLINE OmegaWorld<Real> after_gyroscopic_torque(const Gyroscopic& solver,
                                                         const Inertia& inertia,
                                                         const Quaternion<Real>& q,
                                                         const OmegaWorld<Real>& omega, Real h) {
    return OmegaWorld<Real>(after_gyroscopic_torque(solver, inertia, q, omega.in_the_world, h));
}

/// The kinetic energy of the rotation, J.
template <class Inertia, class Real>
Real kinetic_energy(const Inertia& inertia, const OmegaBody<Real>& omega) {
    return kinetic_energy(inertia, omega.in_the_body);
}
/// The kinetic energy of the rotation, J, for a body of orientation `q`.
template <class Inertia, class Real>
Real kinetic_energy(const Inertia& inertia, const Quaternion<Real>& q,
                    const OmegaWorld<Real>& omega) {
    return kinetic_energy(inertia, in_body(q, omega));
}

/// \cond
// A mix-up of the two does not compile, and the message says why.
namespace detail {
template <class>
inline constexpr bool mixed_up = true;
}
template <class Gyroscopic, class Inertia, class Real>
OmegaWorld<Real> after_gyroscopic_torque(const Gyroscopic&, const Inertia&,
                                         const OmegaWorld<Real>& omega, Real) {
    static_assert(
        !detail::mixed_up<Real>,
        "timestep: this angular velocity is in the world's axes: hand over the orientation, too");
    return omega;
}
template <class Gyroscopic, class Inertia, class Real>
OmegaBody<Real> after_gyroscopic_torque(const Gyroscopic&, const Inertia&, const Quaternion<Real>&,
                                        const OmegaBody<Real>& omega, Real) {
    static_assert(!detail::mixed_up<Real>,
                  "timestep: this angular velocity is in the body's axes: it takes no orientation");
    return omega;
}
template <class Inertia, class Real>
Real kinetic_energy(const Inertia&, const OmegaWorld<Real>&) {
    static_assert(
        !detail::mixed_up<Real>,
        "timestep: this angular velocity is in the world's axes: hand over the orientation, too");
    return 0;
}
/// \endcond

}  // namespace timestep
