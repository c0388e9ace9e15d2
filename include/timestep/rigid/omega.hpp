#pragma once
/// \file
/// An angular velocity that knows its axes: for engines, which have both and mix them up.

#include <utility>

#include <timestep/rigid/body.hpp>

namespace timestep {

/// ω in the body's axes, rad/s. The chapters write a bare vector, and say where it is; this is the
/// same three numbers, and becomes a bare vector by its name only.
template <class Real>
struct OmegaBody {
    Vector3<Real> in_the_body;  ///< the numbers
    /// So that nothing is one by chance.
    explicit OmegaBody(Vector3<Real> numbers) : in_the_body(std::move(numbers)) {}
};
/// ω in the world's axes, rad/s, as engines keep it.
template <class Real>
struct OmegaWorld {
    Vector3<Real> in_the_world;  ///< the numbers
    /// So that nothing is one by chance.
    explicit OmegaWorld(Vector3<Real> numbers) : in_the_world(std::move(numbers)) {}
};

/// The same ω in the body's axes; only the orientation leads across.
template <class Real>
TIMESTEP_INLINE OmegaBody<Real> in_body(const Quaternion<Real>& q, const OmegaWorld<Real>& omega) {
    return OmegaBody<Real>(in_body(Matrix3<Real>(q.toRotationMatrix()), omega.in_the_world));
}
/// And back.
template <class Real>
TIMESTEP_INLINE OmegaWorld<Real> in_world(const Quaternion<Real>& q, const OmegaBody<Real>& omega) {
    return OmegaWorld<Real>(in_world(Matrix3<Real>(q.toRotationMatrix()), omega.in_the_body));
}

/// ω after `h` seconds of the gyroscopic torque, by `solver`: what solver.step() gives.
template <class Gyroscopic, class Inertia, class Real>
TIMESTEP_INLINE OmegaBody<Real> after_gyroscopic_torque(const Gyroscopic& solver,
                                                        const Inertia& inertia,
                                                        const OmegaBody<Real>& omega, Real h) {
    if constexpr (!Inertia::gyroscopic)
        return omega;
    else
        return OmegaBody<Real>(solver.step(inertia, omega.in_the_body, h));
}
/// The same of one in the world, for which it takes the orientation.
template <class Gyroscopic, class Inertia, class Real>
TIMESTEP_INLINE OmegaWorld<Real> after_gyroscopic_torque(const Gyroscopic& solver,
                                                         const Inertia& inertia,
                                                         const Quaternion<Real>& q,
                                                         const OmegaWorld<Real>& omega, Real h) {
    return OmegaWorld<Real>(after_gyroscopic_torque(solver, inertia, q, omega.in_the_world, h));
}

/// The kinetic energy, J.
template <class Inertia, class Real>
Real kinetic_energy(const Inertia& inertia, const OmegaBody<Real>& omega) {
    return kinetic_energy(inertia, omega.in_the_body);
}
/// The same of one in the world.
template <class Inertia, class Real>
Real kinetic_energy(const Inertia& inertia, const Quaternion<Real>& q,
                    const OmegaWorld<Real>& omega) {
    return kinetic_energy(inertia, in_body(q, omega));
}

/// \cond
// Mixed up, each is refused by a line that says so.
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
