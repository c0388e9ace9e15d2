#pragma once
/// \file
/// A capsule on a plane: gravity, two contacts, friction and rolling resistance, with any treatment
/// of the gyroscopic torque. `step` is a whole physics engine for one body.

#include <algorithm>
#include <cmath>

#include <timestep/gyroscopic/lagged_inertia.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/body_scene.hpp>
#include <timestep/sums.hpp>

/// \namespace timestep::plane
/// A capsule, the plane z = 0 that carries it, and one step of the two, in `double`.
namespace timestep::plane {

using V = Vector3<double>;                      ///< a vector, world coordinates
using M = Matrix3<double>;                      ///< a matrix, world coordinates
using Orientation = Quaternion<double>;         ///< from body to world coordinates
using Turning = RigidState<double>;             ///< time, orientation and angular velocity
using BodyState = timestep::BodyState<double>;  ///< and the centre of mass with its velocity
using Flat = Eigen::Vector2d;                   ///< the part of a vector along the plane

/// The orientation that gives a contact its lever arm: that at the start of the step, as in
/// engines, or the mean of those at the start and at the end.
enum class Arms {
    start,  ///< the arm at the start of the step
    middle  ///< the mean arm of the step
};

/// The plane z = 0.
struct Ground {
    double gravity = 9.81;     ///< m/s², downwards
    double friction = 0.5;     ///< Coulomb's coefficient
    double rolling = 0.1;      ///< coefficient of rolling resistance, in radii; 0: none
    Arms arms = Arms::middle;  ///< lever arms of the contacts
};

/// A capsule along the body's z axis; with `half_length` = 0 a ball.
template <class Inertia>
struct Capsule {
    Inertia inertia;     ///< kg m²
    double mass;         ///< kg
    double radius;       ///< m
    double half_length;  ///< m, from the centre to the centres of the half balls

    /// The number of half balls that may touch the plane: 2, or 1 of a ball.
    int ends() const { return half_length > 0 ? 2 : 1; }
    /// The vector from the centre of mass to the centre of half ball `i`, m, world coordinates.
    V end(const Orientation& q, int i) const {
        return q * V(0, 0, i == 0 ? half_length : -half_length);
    }
};

/// The effect of the plane on one end of the body in a step.
struct Contact {
    V arm = V::Zero();             ///< from the centre of mass, m
    double gap = 0;                ///< between half ball and plane at the start of the step, m
    double normal = 0;             ///< impulse away from the plane, N s
    Flat friction = Flat::Zero();  ///< impulse along the plane, N s
    M response = M::Zero();        ///< change of velocity at the contact by a unit impulse, 1/kg
};
/// The effect of the plane on the whole body in a step.
struct Contacts {
    Contact at[2];                ///< the ends
    int count = 0;                ///< the number of ends
    Flat rolling = Flat::Zero();  ///< angular impulse, N m s
    double sunk = 0;              ///< how far the body had to be lifted out of the plane, m
};

/// Kinetic and potential energy, J; zero for a ball at rest on the plane.
template <class Inertia>
double energy(const Capsule<Inertia>& body, const Ground& ground, const BodyState& m) {
    return kinetic_energy(body.inertia, m.turning) +
           body.mass * (m.v.squaredNorm() / 2 + ground.gravity * (m.x.z() - body.radius));
}

/// The state of a body that spins with `omega`, rad/s, and is otherwise at rest, on the plane or
/// `height` m above it.
template <class Inertia>
BodyState placed(const Capsule<Inertia>& body, const Orientation& q, const V& omega,
                 double height = 0) {
    return {{0, q, omega}, {0, 0, height + body.radius + std::fabs(body.end(q, 0).z())}, V::Zero()};
}

/// A treatment of the gyroscopic torque in two parts: a share of the step before the contacts, the
/// rest after them, just before the body rotates. With 1 all of it comes before (as in engines),
/// with 0 all of it after.
template <class Gyroscopic>
struct AroundContacts {
    Gyroscopic rule;    ///< the treatment, which changes ω
    double before = 0;  ///< the share before the contacts, from 0 to 1
};

/// \cond
namespace detail {
// The two places in a step where the ways to treat the torque differ. All but the lagged inertia
// change ω first and the orientation afterwards; that one keeps ω, and changes it with the
// orientation.
template <class Gyroscopic, class Inertia>
V spun(const Gyroscopic& solver, const Inertia& inertia, const Turning& s, double h) {
    return after_gyroscopic_torque(solver, inertia, s.q, s.omega, h);
}
template <class Inertia>
V spun(const LaggedInertia&, const Inertia&, const Turning& s, double) {
    return s.omega;
}
template <class Gyroscopic, class Inertia>
Turning moved(const Gyroscopic&, const Inertia&, const Turning& s, double h) {
    return {s.t + h, rotated(s.q, s.omega, h), s.omega};
}
template <class Inertia>
Turning moved(const LaggedInertia& solver, const Inertia& inertia, const Turning& s, double h) {
    return step_rotation(solver, inertia, s, h);
}

template <class Gyroscopic, class Inertia>
V spun(const AroundContacts<Gyroscopic>& solver, const Inertia& inertia, const Turning& s,
       double h) {
    return solver.before > 0 ? spun(solver.rule, inertia, s, solver.before * h) : s.omega;
}
template <class Gyroscopic, class Inertia>
Turning moved(const AroundContacts<Gyroscopic>& solver, const Inertia& inertia, const Turning& s,
              double h) {
    const double after = 1 - solver.before;
    const V omega = after > 0 ? spun(solver.rule, inertia, s, after * h) : s.omega;
    return moved(solver.rule, inertia, Turning{s.t, s.q, omega}, h);
}

inline Flat within(double limit, const Flat& impulse) {
    const double length = norm(impulse);
    return length > limit ? Flat(impulse * (limit / length)) : impulse;
}
}  // namespace detail
/// \endcond

/// Finds the contacts' impulses and applies them to the velocities.
///
/// Sequential impulses: each contact in order gets the impulse that it would need if it were alone,
/// and after some rounds all of them agree. Sums are clamped, not increments, so a contact may take
/// back impulse from an earlier round.
///
/// - normal: the gap must not close beyond zero: v_n ≥ −gap/h, impulse ≥ 0, and only one of them
///   other than zero. No bouncing.
/// - friction: stops the sliding, up to Coulomb's μ times the normal impulse.
/// - rolling: stops the turning about the axes in the plane, up to coefficient × radius × normal
///   impulse: the plane gives way a little, and pushes that far in front of the centre.
///   Turning about the normal is not rolling and is left alone.
inline void solve(Contacts& contacts, double mass, const M& inverse_inertia, const Ground& ground,
                  double radius, double h, V& v, V& omega) {
    const Eigen::Matrix2d roll = inverse_inertia.topLeftCorner<2, 2>().inverse();
    Eigen::Matrix2d slide[2];
    for (int i = 0; i < contacts.count; ++i) {
        Contact& c = contacts.at[i];
        const M arm = skew(c.arm);
        c.response = M::Identity() / mass - times(times(arm, inverse_inertia), arm);
        slide[i] = c.response.topLeftCorner<2, 2>().inverse();
    }
    for (int round = 0; round < 12; ++round) {
        double pressed = 0;
        for (int i = 0; i < contacts.count; ++i) {
            Contact& c = contacts.at[i];
            const auto velocity = [&] { return V(v + omega.cross(c.arm)); };
            const auto push = [&](const V& impulse) {
                v += impulse / mass;
                omega += times(inverse_inertia, V(c.arm.cross(impulse)));
            };
            const double allowed = -std::max(0.0, c.gap) / h;
            const double normal =
                std::max(0.0, c.normal + (allowed - velocity().z()) / c.response(2, 2));
            push({0, 0, normal - c.normal});
            c.normal = normal;
            pressed += normal;

            const Flat sliding = velocity().head<2>();
            const Flat friction =
                detail::within(ground.friction * normal, c.friction - times(slide[i], sliding));
            const Flat more = friction - c.friction;
            push({more.x(), more.y(), 0});
            c.friction = friction;
        }
        const Flat turning = omega.head<2>();
        const Flat rolling = detail::within(ground.rolling * radius * pressed,
                                            contacts.rolling - times(roll, turning));
        const Flat more = rolling - contacts.rolling;
        omega += times(inverse_inertia, V(more.x(), more.y(), 0));
        contacts.rolling = rolling;
    }
}

// The arm in the middle: `rotated` takes the body's point e to e₂ with e₂ − e = h ω × (e + e₂)/2,
// with no error. So with (e + e₂)/2 as its arm the gap at the end of the step is gap + h v_n, with
// no error either; with e it is another one, by about h²|ω × (ω × e)|/2, and who lifts the body out
// of the plane by that works against gravity, step after step. e₂ needs the ω that the contacts
// have yet to find: so they are solved a few times, each time from the start with the last ω.
/// Changes the velocities `v` and `omega`, which the body would have without the plane, to those
/// with it.
template <class Inertia>
void touch(const Capsule<Inertia>& body, const Ground& ground, const BodyState& m1, double h,
           Contacts& contacts, V& v, V& omega) {
    const M R = m1.turning.q.toRotationMatrix();
    M inverse;
    for (int i = 0; i < 3; ++i)
        inverse.col(i) = in_world(R, body.inertia.velocity(in_body(R, V(V::Unit(i)))));

    const V v1 = v, omega1 = omega;
    const int passes = ground.arms == Arms::start ? 1 : 4;
    for (int pass = 0; pass < passes; ++pass) {
        const Orientation q2 = rotated(m1.turning.q, omega, h);
        contacts = {};
        contacts.count = body.ends();
        for (int i = 0; i < body.ends(); ++i) {
            const V e = body.end(m1.turning.q, i), e2 = body.end(q2, i);
            const V middle = ground.arms == Arms::start ? e : V((e + e2) / 2);
            contacts.at[i].arm = middle - body.radius * V::UnitZ();
            contacts.at[i].gap = m1.x.z() + e.z() - body.radius;
        }
        v = v1, omega = omega1;
        solve(contacts, body.mass, inverse, ground, body.radius, h, v, omega);
    }
}

/// One step of `h` seconds of semi-implicit Euler: forces, contacts, positions (N46). Gravity and
/// the impulses are explicit; `solver` treats the gyroscopic torque. `contacts` is output only.
template <class Gyroscopic, class Inertia>
BodyState step(const Gyroscopic& solver, const Capsule<Inertia>& body, const Ground& ground,
               const BodyState& m1, double h, Contacts& contacts) {
    V v = m1.v - h * ground.gravity * V::UnitZ();
    V omega = detail::spun(solver, body.inertia, m1.turning, h);
    touch(body, ground, m1, h, contacts, v, omega);

    const Turning turning{m1.turning.t, m1.turning.q, omega};
    BodyState m2{detail::moved(solver, body.inertia, turning, h), m1.x + h * v, v};
    for (int i = 0; i < body.ends(); ++i)
        contacts.sunk =
            std::max(contacts.sunk, body.radius - m2.x.z() - body.end(m2.turning.q, i).z());
    m2.x.z() += contacts.sunk;
    return m2;
}

}  // namespace timestep::plane
