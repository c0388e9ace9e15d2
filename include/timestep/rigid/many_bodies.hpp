#pragma once
/// \file
/// Many rotating bodies, sorted by kind of inertia, in packs.

#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include <timestep/lanes.hpp>
#include <timestep/rigid/bodies.hpp>

namespace timestep {

/// \cond
namespace detail {
// Puts one body's numbers into the lanes from `first` on of a pack.
template <class L, class Real>
void set_lanes(L& pack, int first, const Real& one) {
    for (int i = first; i < L::lanes; ++i) pack.set(i, one);
}
template <class L, class Real, int Size>
void set_lanes(Eigen::Matrix<L, Size, 1>& pack, int first,
               const Eigen::Matrix<Real, Size, 1>& one) {
    for (int k = 0; k < Size; ++k) set_lanes(pack[k], first, one[k]);
}
template <class L, class Real>
void set_lanes(UniformInertia<L>& pack, int first, const UniformInertia<Real>& one) {
    set_lanes(pack.moment, first, one.moment);
}
template <class L, class Real>
void set_lanes(SymmetricInertia<L>& pack, int first, const SymmetricInertia<Real>& one) {
    L across = pack.across, along = pack.along;
    set_lanes(across, first, one.across), set_lanes(along, first, one.along);
    pack = SymmetricInertia<L>(across, along);
}
template <class L, class Real>
void set_lanes(PrincipalInertia<L>& pack, int first, const PrincipalInertia<Real>& one) {
    Vector3<L> moments = pack.moments;
    set_lanes(moments, first, one.moments);
    pack = PrincipalInertia<L>(moments.x(), moments.y(), moments.z());
}
// One inertia in every lane.
template <class L, class Real>
UniformInertia<L> in_every_lane(const UniformInertia<Real>& one) {
    return UniformInertia<L>(one.moment);
}
template <class L, class Real>
SymmetricInertia<L> in_every_lane(const SymmetricInertia<Real>& one) {
    return {one.across, one.along};
}
template <class L, class Real>
PrincipalInertia<L> in_every_lane(const PrincipalInertia<Real>& one) {
    return {one.moments.x(), one.moments.y(), one.moments.z()};
}
}  // namespace detail
/// \endcond

/// One body of one kind per lane: orientations and angular velocities in world coordinates, as in
/// RigidState, with a pack for every number.
template <class Inertia>
struct BodyPack {
    using Pack = typename Inertia::Scalar;  ///< the pack

    Inertia inertia;      ///< kg m²
    Quaternion<Pack> q;   ///< orientation
    Vector3<Pack> omega;  ///< angular velocity in world coordinates, rad/s

    /// One step of `h` seconds of all bodies in the pack, as step_rotation() steps one.
    template <class Gyroscopic>
    TIMESTEP_INLINE void step(const Gyroscopic& solver, Pack h) {
        omega = after_gyroscopic_torque(solver, inertia, q, omega, h);
        q = rotated(q, omega, h);
    }
};

/// Bodies of several kinds, all at the same time `t`:
/// `ManyBodies<float, UniformInertia, PrincipalInertia> all;`
///
/// A pack holds one kind only, so no gyroscopic torque is computed for a ball. All numbers of a
/// pack lie side by side, so a step reads one stretch of memory instead of a dozen. As in Springs,
/// the last pack of a kind is filled up with copies of its last body.
template <class Real, template <class> class... Kinds>
class ManyBodies {
public:
    using Pack = Lanes<Real>;  ///< bodies stepped at once

    /// Adds a body to the others of its kind, with its orientation scaled to length one; `omega` in
    /// world coordinates, rad/s. Throws `std::invalid_argument` if its state or |ω|² is not finite.
    template <template <class> class Kind>
    void add(const Kind<Real>& inertia, const Quaternion<Real>& q, const Vector3<Real>& omega) {
        if (!is_finite(RigidState<Real>{Real(t), q, omega}))
            refuse("body: its state must be finite, its orientation not zero");
        const Real speed = std::hypot(omega.x(), omega.y(), omega.z());
        if (!is_finite(speed * speed)) refuse("speed", speed, "so low that its square is a number");
        const Quaternion<Real> orientation = as_rotation(q);
        auto& [size, packs] = group<Kind>();
        const int lane = int(size % Pack::lanes);
        if (lane == 0)
            packs.push_back({detail::in_every_lane<Pack>(inertia), Quaternion<Pack>::Identity(),
                             Vector3<Pack>::Zero()});
        detail::set_lanes(packs.back().inertia, lane, inertia);
        detail::set_lanes(packs.back().q.coeffs(), lane, orientation.coeffs());
        detail::set_lanes(packs.back().omega, lane, omega);
        ++size;
    }

    /// The number of bodies of a kind.
    template <template <class> class Kind>
    std::size_t size() const {
        return group<Kind>().size;
    }
    /// The packs of a kind, to step them yourself.
    template <template <class> class Kind>
    std::vector<BodyPack<Kind<Pack>>>& packs() {
        return group<Kind>().packs;
    }
    /// The state of body `i` of a kind.
    template <template <class> class Kind>
    RigidState<Real> state(std::size_t i) const {
        const auto& pack = group<Kind>().packs[i / Pack::lanes];
        const int lane = int(i % Pack::lanes);
        const auto& q = pack.q;
        return {Real(t),
                {q.w()[lane], q.x()[lane], q.y()[lane], q.z()[lane]},
                {pack.omega.x()[lane], pack.omega.y()[lane], pack.omega.z()[lane]}};
    }

    /// One step of `h` seconds without external torques, kind after kind.
    /// [step all]
    template <class Gyroscopic>
    void step(const Gyroscopic& solver, Real h) {
        const auto step_all = [&](auto& packs) {
            for (auto& pack : packs) pack.step(solver, h);
        };
        (step_all(packs<Kinds>()), ...);
        t += h;
    }
    /// [step all]

    double t = 0;  ///< time, s; a sum in `float` would be off by seconds per hour

private:
    /// \cond
    template <template <class> class Kind>
    struct Group {
        std::size_t size = 0;
        std::vector<BodyPack<Kind<Pack>>> packs;
    };
    /// \endcond
    template <template <class> class Kind>
    auto& group() {
        return std::get<Group<Kind>>(groups_);
    }
    template <template <class> class Kind>
    const auto& group() const {
        return std::get<Group<Kind>>(groups_);
    }

    std::tuple<Group<Kinds>...> groups_;
};

}  // namespace timestep
