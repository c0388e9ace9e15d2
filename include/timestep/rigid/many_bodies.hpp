#pragma once
/// \file
/// Many bodies that turn, sorted by what their inertia needs, in packs.

#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include <timestep/lanes.hpp>
#include <timestep/rigid/bodies.hpp>

namespace timestep {

/// \cond
namespace detail {
// Puts one body's numbers into lane `i` of a pack's.
template <class L, class Real, int Size>
void set_lane(Eigen::Matrix<L, Size, 1>& pack, int i, const Eigen::Matrix<Real, Size, 1>& one) {
    for (int k = 0; k < Size; ++k) pack[k].set(i, one[k]);
}
template <class L, class Real>
void set_lane(UniformInertia<L>& pack, int i, const UniformInertia<Real>& one) {
    pack.moment.set(i, one.moment);
}
template <class L, class Real>
void set_lane(SymmetricInertia<L>& pack, int i, const SymmetricInertia<Real>& one) {
    pack.across.set(i, one.across);
    pack.along.set(i, one.along);
    pack.precession_ratio.set(i, one.precession_ratio);
}
template <class L, class Real>
void set_lane(PrincipalInertia<L>& pack, int i, const PrincipalInertia<Real>& one) {
    set_lane(pack.moments, i, one.moments);
    set_lane(pack.unit, i, one.unit);
    set_lane(pack.ratio, i, one.ratio);
}
// The same inertia in every lane.
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

/// As many bodies of one kind as the processor adds numbers at once: orientations and angular
/// velocities in world coordinates, as in RigidState, with a pack for every number.
template <class Inertia>
struct BodyPack {
    using Pack = typename Inertia::Scalar;  ///< the pack

    Inertia inertia;      ///< kg m²
    Quaternion<Pack> q;   ///< orientation
    Vector3<Pack> omega;  ///< angular velocity in world coordinates, rad/s

    /// One step of `h` seconds, of all of them: step_rotation(), that steps one.
    /// [step]
    template <class Gyroscopic>
    TIMESTEP_INLINE void step(const Gyroscopic& solver, Pack h) {
        omega = after_gyroscopic_torque(solver, inertia, q, omega, h);
        q = rotated(q, omega, h);
    }
    /// [step]
};

/// Bodies of several kinds, all at the same time `t`:
/// `ManyBodies<float, UniformInertia, PrincipalInertia> all;`
///
/// A pack holds one kind only, so a ball stands in no pack that computes a gyroscopic torque. All
/// of a pack's numbers lie side by side: a step needs them all, and fetches one stretch of memory
/// instead of a dozen. As in Springs, the last pack of a kind is filled up with copies of its last
/// body.
template <class Real, template <class> class... Kinds>
class ManyBodies {
public:
    using Pack = Lanes<Real>;  ///< so many are stepped at once

    /// Adds a body to the others of its kind, its orientation scaled to length one. Throws
    /// `std::invalid_argument` where its state is not finite, or |ω|² is not.
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
        for (int i = lane; i < Pack::lanes; ++i) {
            detail::set_lane(packs.back().inertia, i, inertia);
            detail::set_lane(packs.back().q.coeffs(), i, orientation.coeffs());
            detail::set_lane(packs.back().omega, i, omega);
        }
        ++size;
    }

    /// How many there are of a kind.
    template <template <class> class Kind>
    std::size_t size() const {
        return group<Kind>().size;
    }
    /// The packs of a kind, to step them by hand.
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

    /// One step of `h` seconds without torques from outside, kind after kind.
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

    double t = 0;  ///< time, s; such a sum in `float` would be off by seconds an hour

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
