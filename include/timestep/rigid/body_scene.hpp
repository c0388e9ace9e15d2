#pragma once
/// \file
/// The terms that act on a body. The compiler composes a step from those that a scene names.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <tuple>
#include <type_traits>

#include <timestep/checks.hpp>
#include <timestep/inline.hpp>
#include <timestep/rigid/body.hpp>

namespace timestep {

/// The state of a body that moves and rotates.
template <class Real>
struct BodyState {
    RigidState<Real> turning;  ///< time, orientation, angular velocity
    Vector3<Real> x;           ///< the centre of mass, m
    Vector3<Real> v;           ///< its velocity, m/s
};

/// Returns the body if a scene can step it: mass and radius, if it has them, are above zero, and
/// 1/m and r²/I, by which the ground divides, neither overflow nor vanish. Throws
/// `std::invalid_argument` otherwise. Steps check nothing: if you step a body without `Bodies`,
/// call this once.
template <class Body>
const Body& checked(const Body& body) {
    const auto usable = [](const char* name, auto value, auto term) {
        positive(name, value);
        if (!is_finite(term) || term == 0)
            refuse(name, value, "such that 1/m and r²/I are finite and above zero");
    };
    if constexpr (requires { body.mass; }) usable("mass", body.mass, 1 / body.mass);
    if constexpr (requires { body.radius, body.inertia.moment; })
        usable("radius", body.radius, body.radius * body.radius * (1 / body.inertia.moment));
    return body;
}

/// Returns the state if all of it is finite and the squares of its speeds are too. Throws
/// `std::invalid_argument` otherwise.
template <class Real>
const BodyState<Real>& checked(const BodyState<Real>& m) {
    if (!is_finite(m.turning) || !is_finite(m.x) || !is_finite(m.v))
        refuse("motion: must be finite, its orientation not zero");
    for (const Real speed : {m.v.stableNorm(), m.turning.omega.stableNorm()})
        if (!is_finite(speed * speed)) refuse("speed", speed, "so low that its square is a number");
    return m;
}

template <class Real>
struct Weight;
template <class Real>
struct Ground;
template <class Real>
struct RollingResistance;

/// \cond
namespace detail {
template <class Term>
inline constexpr bool is_weight = false;
template <class Real>
inline constexpr bool is_weight<Weight<Real>> = true;
template <class Term>
inline constexpr bool is_ground = false;
template <class Real>
inline constexpr bool is_ground<Ground<Real>> = true;
template <class Term>
inline constexpr bool is_rolling = false;
template <class Real>
inline constexpr bool is_rolling<RollingResistance<Real>> = true;

// The place of the first `true`, or the number of terms; and the place behind the last `true`, or
// 0.
consteval auto first(std::initializer_list<bool> terms) {
    return std::find(terms.begin(), terms.end(), true) - terms.begin();
}
consteval auto behind_last(std::initializer_list<bool> terms) {
    std::ptrdiff_t place = 0, behind = 0;
    for (const bool term : terms) ++place, behind = term ? place : behind;
    return behind;
}
}  // namespace detail
/// \endcond

/// All that acts on a body, in this order:
/// `BodyScene{Weight(9.81), Gyroscopic(passive_gyroscopic)}` is debris in the air,
/// `BodyScene{Weight(9.81), Ground(0.5), RollingResistance(0.01)}` a ball on a lawn.
///
/// A term changes the velocities of a state. It may also read or write `load`, the impulse, N s,
/// with which the ground has carried the body in this step. Terms that are not named cost no
/// instruction. A body needs only what its terms use: a scene without ground needs no radius.
template <class... Terms>
class BodyScene {
    static_assert((std::is_same_v<Terms, std::decay_t<Terms>> && ...),
                  "timestep: the terms of a BodyScene are neither const nor references");
    static_assert(detail::first({detail::is_ground<Terms>...}) <=
                      detail::first({detail::is_rolling<Terms>...}),
                  "timestep: in a BodyScene RollingResistance comes after Ground, whose load it "
                  "needs");
    static_assert(detail::behind_last({detail::is_weight<Terms>...}) <=
                      detail::first({detail::is_ground<Terms>...}),
                  "timestep: in a BodyScene Ground comes after Weight, which it has to carry");

public:
    /// Copies the terms, which have checked their parameters.
    explicit BodyScene(const Terms&... terms) : terms_(terms...) {}

    // In place: a state is fourteen numbers, and a scene that changes only a few of them does not
    // copy the others.
    /// One step of `h` seconds of semi-implicit Euler: every term changes the velocities, and the
    /// new velocities move the body (N46).
    /// [step]
    template <class Body, class Real>
    TIMESTEP_INLINE void step(const Body& body, BodyState<Real>& m, Real h) const {
        Real load = 0;
        const auto act = [&](const auto&... term) { (term(body, m, load, h), ...); };
        std::apply(act, terms_);
        m.turning.t += h;
        m.turning.q = rotated(m.turning.q, m.turning.omega, h);
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

    /// `gravity` in m/s², finite. Throws `std::invalid_argument`.
    explicit Weight(Real gravity_) : gravity(finite("gravity", gravity_)) {}

    /// v changes by h g.
    template <class Body>
    TIMESTEP_INLINE void operator()(const Body&, BodyState<Real>& m, Real&, Real h) const {
        m.v.z() -= h * gravity;
    }
};

/// The gyroscopic torque, as `Solver` treats it. For a body whose inertia has none, nothing is
/// compiled.
template <class Solver>
struct Gyroscopic {
    Solver solver;  ///< such as passive_gyroscopic

    /// Takes any solver of timestep/gyroscopic that changes ω alone.
    explicit Gyroscopic(const Solver& solver_) : solver(solver_) {}

    /// Changes ω as the solver does. Needs `body.inertia`.
    template <class Body, class Real>
    TIMESTEP_INLINE void operator()(const Body& body, BodyState<Real>& m, Real&, Real h) const {
        auto& [t, q, omega] = m.turning;
        if constexpr (decltype(body.inertia)::gyroscopic)  // not even a copy of ω
            omega = after_gyroscopic_torque(solver, body.inertia, q, omega, h);
    }
};

// One contact needs no iteration: the normal impulse leaves ω alone, because its arm has its
// direction, and friction changes only what is perpendicular to it.
//
// An impulse p along the ground changes the velocity of the contact by (1/m + r²/I) p.
/// The ground z = 0 under a ball: a normal force and Coulomb friction, without bouncing.
template <class Real>
struct Ground {
    Real friction;  ///< Coulomb's coefficient

    /// `friction` zero or more. Throws `std::invalid_argument`.
    explicit Ground(Real friction_) : friction(not_negative("friction", friction_)) {}

    /// Keeps the gap from closing beyond zero: v_z ≥ −gap/h. Needs `body.mass`, `body.radius` and
    /// the `body.inertia` of a ball. The velocities become NaN if the square of the contact's
    /// velocity is too large for a number.
    template <class Body>
    TIMESTEP_INLINE void operator()(const Body& body, BodyState<Real>& m, Real& load,
                                    Real h) const {
        Vector3<Real>& v = m.v;
        Vector3<Real>& omega = m.turning.omega;
        const Real r = body.radius, inverse_inertia = 1 / body.inertia.moment;
        const Real gap = m.x.z() - r;
        const Real lift = -std::max(gap, Real(0)) / h - v.z();
        if (lift <= 0) return;  // a NaN goes on, and is seen
        load = body.mass * lift;
        v.z() += lift;

        const Real u = v.x() - r * omega.y(), w = v.y() + r * omega.x();  // of the contact
        const Real square = u * u + w * w, speed = std::sqrt(square);
        const Real stop = speed / (1 / body.mass + r * r * inverse_inertia);  // N s that stop it
        if (stop <= 0) return;
        const Real share = -std::min(stop, friction * load) * (speed / square);  // NaN if infinite
        const Real px = share * u, py = share * w;
        v.x() += px / body.mass, v.y() += py / body.mass;
        omega.x() += r * inverse_inertia * py, omega.y() -= r * inverse_inertia * px;
    }
};

/// Rolling resistance: the ground gives way a little and pushes in front of the centre, which slows
/// the spin about the axes in the plane, but not about the normal. Name it after Ground.
template <class Real>
struct RollingResistance {
    Real coefficient;  ///< distance in front of the centre, in radii

    /// `coefficient` zero or more. Throws `std::invalid_argument`.
    explicit RollingResistance(Real c) : coefficient(not_negative("rolling resistance", c)) {}

    /// Slows the spin, at most to a stop. ω becomes NaN if its square is too large for a number.
    template <class Body>
    TIMESTEP_INLINE void operator()(const Body& body, BodyState<Real>& m, Real& load, Real) const {
        Vector3<Real>& omega = m.turning.omega;
        const Real rate = std::sqrt(omega.x() * omega.x() + omega.y() * omega.y());
        const Real most = coefficient * body.radius * load / body.inertia.moment;
        const Real left = rate > most ? (rate - most) / rate : 0;  // NaN if infinite
        omega.x() *= left;
        omega.y() *= left;
    }
};

}  // namespace timestep
