#pragma once
/// \file
/// What acts on a body: a step of it is put together by the compiler from the terms that a scene
/// names.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

#include <timestep/checks.hpp>
#include <timestep/inline.hpp>
#include <timestep/rigid/body.hpp>

namespace timestep {

/// A body that flies and turns.
template <class Real>
struct Motion {
    RigidState<Real> turning;  ///< time, attitude, angular velocity
    Vector3<Real> x;           ///< the centre of mass, m
    Vector3<Real> v;           ///< its velocity, m/s
};

/// \cond
namespace detail {
template <class Term>
inline constexpr bool is_ground = false;
template <class Term>
inline constexpr bool needs_load = false;

// Does nothing that needs the load of the ground come before the ground?
template <class... Terms>
consteval bool ground_comes_first() {
    const bool ground[] = {is_ground<Terms>..., false}, needs[] = {needs_load<Terms>..., false};
    bool needed = false, good = true;
    for (std::size_t i = 0; i < sizeof...(Terms); ++i) {
        if (ground[i]) good = good && !needed;
        needed = needed || needs[i];
    }
    return good;
}
}  // namespace detail
/// \endcond

/// All that acts on a body, in this order:
/// `BodyScene{Weight(9.81), Gyroscopic(passive_gyroscopic)}` is debris in the air,
/// `BodyScene{Weight(9.81), Ground(0.5), RollingResistance(0.01)}` a ball on a lawn.
///
/// A term changes the velocities in a motion. It may also read or write `load`, the impulse in N s
/// with which the ground has carried the body in this step. A term that is not named does not
/// exist, and neither do its instructions. What a body must have, its terms say: a scene without
/// ground asks for no radius.
template <class... Terms>
class BodyScene {
    static_assert(detail::ground_comes_first<Terms...>(),
                  "timestep: in a BodyScene RollingResistance comes after Ground, whose load it needs");

public:
    /// Copies the terms, which have checked their parameters themselves.
    explicit BodyScene(const Terms&... terms) : terms_(terms...) {}

    // In place: a motion is fourteen numbers, and a scene that changes only a few of them shall not
    // copy the others.
    /// Takes one step of `h` seconds, as semi-implicit Euler takes it: every term changes the
    /// velocities, and the new velocities move the body (N46).
    /// [step]
    template <class Body, class Real>
    TIMESTEP_INLINE void step(const Body& body, Motion<Real>& m, Real h) const {
        Real load = 0;
        const auto act = [&](const auto&... term) {
            (term(body, m, load, h), ...);
        };
        std::apply(act, terms_);
        m.turning.t += h;
        m.turning.q = turned(m.turning.q, m.turning.omega, h);
        m.x += h * m.v;
    }
    /// [step]

private:
    std::tuple<Terms...> terms_;
};

/// Gravity, downwards along z.
template <class Real>
struct Weight {
    Real gravity;  ///< m/s²

    /// `gravity` in m/s². Throws `std::invalid_argument` where it is not finite.
    explicit Weight(Real gravity_) : gravity(finite("gravity", gravity_)) {}

    /// v changes by h g.
    /// [weight]
    template <class Body>
    TIMESTEP_INLINE void operator()(const Body&, Motion<Real>& m, Real&, Real h) const {
        m.v.z() -= h * gravity;
    }
    /// [weight]
};

/// The gyroscopic torque, as `Solver` treats it; of a body whose inertia has none nothing is
/// compiled.
template <class Solver>
struct Gyroscopic {
    Solver solver;  ///< such as passive_gyroscopic

    /// Any solver of timestep/gyroscopic that changes ω alone.
    explicit Gyroscopic(const Solver& solver_) : solver(solver_) {}

    /// ω as the solver leaves it. Needs `body.inertia`.
    /// [gyroscopic]
    template <class Body, class Real>
    TIMESTEP_INLINE void operator()(const Body& body, Motion<Real>& m, Real&, Real h) const {
        auto& [t, q, omega] = m.turning;
        if constexpr (decltype(body.inertia)::gyroscopic)  // not even a copy of ω
            omega = after_gyroscopic_torque(solver, body.inertia, q, omega, h);
    }
    /// [gyroscopic]
};

// One contact needs no rounds: the normal impulse leaves ω alone, as its arm has its direction, and
// what friction changes is at right angles to it.
//
// An impulse p along the ground changes the velocity of the contact by (1/m + r²/I) p.
/// The ground z = 0 under a ball: it carries, and it rubs (Coulomb). It does not throw back.
template <class Real>
struct Ground {
    Real friction;  ///< Coulomb's coefficient

    /// `friction` zero or more. Throws `std::invalid_argument`.
    explicit Ground(Real friction_) : friction(not_negative("friction", friction_)) {}

    /// The gap must not close beyond zero: v_z ≥ −gap/h. Needs `body.mass`, `body.radius` and the
    /// `body.inertia` of a ball.
    /// [ground]
    template <class Body>
    TIMESTEP_INLINE void operator()(const Body& body, Motion<Real>& m, Real& load, Real h) const {
        Vector3<Real>& v = m.v;
        Vector3<Real>& omega = m.turning.omega;
        const Real r = body.radius, inverse_inertia = 1 / body.inertia.moment;
        const Real gap = m.x.z() - r;
        const Real lift = -std::max(gap, Real(0)) / h - v.z();
        if (!(lift > 0)) return;
        load = body.mass * lift;
        v.z() += lift;

        const Real u = v.x() - r * omega.y(), w = v.y() + r * omega.x();  // of the contact
        const Real speed = std::sqrt(u * u + w * w);
        const Real stop = speed / (1 / body.mass + r * r * inverse_inertia);  // N s that stop it
        if (!(stop > 0)) return;
        const Real share = -std::min(stop, friction * load) / speed;
        const Real px = share * u, py = share * w;
        v.x() += px / body.mass, v.y() += py / body.mass;
        omega.x() += r * inverse_inertia * py, omega.y() -= r * inverse_inertia * px;
    }
    /// [ground]
};

/// The ground gives way a little, and pushes in front of the centre: it slows the turning about the
/// axes in the plane, and not the one about the normal. To be named after Ground.
template <class Real>
struct RollingResistance {
    Real coefficient;  ///< how far in front, in radii

    /// `coefficient` zero or more. Throws `std::invalid_argument`.
    explicit RollingResistance(Real c) : coefficient(not_negative("rolling resistance", c)) {}

    /// At most as much as stops the turning.
    /// [rolling]
    template <class Body>
    TIMESTEP_INLINE void operator()(const Body& body, Motion<Real>& m, Real& load, Real) const {
        Vector3<Real>& omega = m.turning.omega;
        const Real rate = std::sqrt(omega.x() * omega.x() + omega.y() * omega.y());
        const Real most = coefficient * body.radius * load / body.inertia.moment;
        const Real left = rate > most ? 1 - most / rate : 0;
        omega.x() *= left;
        omega.y() *= left;
    }
    /// [rolling]
};

/// \cond
namespace detail {
template <class Real>
inline constexpr bool is_ground<Ground<Real>> = true;
template <class Real>
inline constexpr bool needs_load<RollingResistance<Real>> = true;
}  // namespace detail
/// \endcond

}  // namespace timestep
