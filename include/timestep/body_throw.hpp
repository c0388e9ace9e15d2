#pragma once
/// \file
/// A throw: the motion of one free body under a solver, compared with its exact motion.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>

#include <timestep/inline.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>

namespace timestep {

/// Frame times: constant, or drawn between two bounds, in one fixed sequence.
class Frames {
public:
    /// From `shortest` to `longest`, s. Throws `std::invalid_argument` unless 0 < shortest ≤
    /// longest.
    Frames(double shortest, double longest)
        : shortest_(positive("shortest frame", shortest)),
          longest_(positive("longest frame", longest)) {
        if (shortest > longest) refuse("shortest frame", shortest, "at most the longest");
    }
    /// The next frame time, s.
    double operator()() {
        return shortest_ + (longest_ - shortest_) * (double(random_() >> 11) / 9007199254740992.0);
    }
    double shortest() const { return shortest_; }        ///< the shortest frame time, s
    double longest() const { return longest_; }          ///< the longest frame time, s
    bool even() const { return shortest_ == longest_; }  ///< whether all frame times are equal

private:
    double shortest_, longest_;
    std::mt19937_64 random_{1};
};

/// The relative difference below which two moments are nearly equal: under the passive step a spin
/// about the third axis then fades within seconds.
inline constexpr double nearly_equal = 0.05;
/// The error of an orientation, rad, from which on it is lost.
inline constexpr double lost_orientation = 0.5;
/// The error of an orientation after two seconds, rad, up to which it is right: too small to see.
inline constexpr double right_orientation = 1e-4;

/// The two moments that are closest to each other.
struct ClosestMoments {
    int odd;                      ///< the axis of the third one, 0, 1 or 2
    double apart;                 ///< their difference over the larger one
    std::array<double, 3> equal;  ///< the moments with their mean for both, kg m²
    /// Whether they differ by no more than nearly_equal.
    bool all_but_equal() const { return apart <= nearly_equal; }
};

/// The two moments that are closest to each other.
inline ClosestMoments closest_moments(const PrincipalInertia<double>& inertia) {
    ClosestMoments found{0, std::numeric_limits<double>::infinity(), {}};
    const Vector3<double>& I = inertia.moments;
    for (int i = 0; i < 3; ++i) {
        const double a = I[(i + 1) % 3], b = I[(i + 2) % 3];
        const double apart = std::abs(a - b) / std::max(a, b);
        if (apart < found.apart) found.odd = i, found.apart = apart;
    }
    const int i = (found.odd + 1) % 3, j = (found.odd + 2) % 3;
    found.equal = {I[0], I[1], I[2]};
    found.equal[std::size_t(i)] = found.equal[std::size_t(j)] = I[i] / 2 + I[j] / 2;
    return found;
}

/// The axis (0, 1 or 2) if this may be a body of revolution: two moments nearly equal, the third
/// different. −1 if there is no such axis. If the body is round, its roll about that axis is
/// invisible; a bar with a flat profile may have such moments too, and its roll is visible.
inline int axis_of_revolution(const PrincipalInertia<double>& inertia) {
    const ClosestMoments closest = closest_moments(inertia);
    const Vector3<double>& I = inertia.moments;
    const double third = I[closest.odd], other = closest.equal[std::size_t((closest.odd + 1) % 3)];
    const bool is_odd = std::abs(third - other) > nearly_equal * std::max(third, other);
    return closest.all_but_equal() && is_odd ? closest.odd : -1;
}

/// The result of a throw. Infinite or NaN if it blew up.
struct Thrown {
    double seconds = 0;      ///< simulated time, s
    double energy = 1;       ///< energy at the end over that at the start
    double most_energy = 1;  ///< largest energy over that at the start
    double spin_left = 1;  ///< spin about the axis of the throw at the end, over that at the start
    double off =
        0;  ///< the orientation's largest error in the first two seconds: 2 sin(α/2) of an angle α;
            ///< NaN if the spin is so fast that the exact orientation is not known
    double axis_off = 0;  ///< the largest error of the direction of axis_of_revolution() in these
                          ///< seconds; NaN if there is no such axis, or if `off` is NaN
    bool lost = false;    ///< whether the axis (without an axis, the orientation) was off by more
                          ///< than lost_orientation
};

/// \cond
namespace detail {
// The splittings divide the body beforehand.
template <class Rule>
auto prepared(const Rule&, const PrincipalInertia<double>& inertia) {
    if constexpr (std::is_same_v<Rule, BallAndRemainder2> ||
                  std::is_same_v<Rule, BallAndRemainder4>)
        return RemainderInertia<double>(inertia);
    else
        return inertia;
}

// ExactFreeBody is off by up to 60 ε for each radian and each of the moments' ratio: is a
// thousandth of it right?
inline bool exact_is_known(const PrincipalInertia<double>& inertia, double radians) {
    const double ratio = inertia.moments.maxCoeff() / inertia.moments.minCoeff();
    return 60 * std::numeric_limits<double>::epsilon() * ratio * radians < 1e-3;
}
}  // namespace detail
/// \endcond

/// No hand throws a body about one of its axes to the last digit, and then all solvers look alike.
/// A spin that is off its axis by less than a hundredth comes back tilted by a hundredth, equally
/// fast.
inline Vector3<double> as_thrown(const Vector3<double>& omega) {
    int axis;
    const double most = omega.cwiseAbs().maxCoeff(&axis), tilt = 0.01;
    Vector3<double> across = omega / most;
    across[axis] = 0;
    if (across.norm() >= tilt) return omega;
    Vector3<double> tilted = Vector3<double>::Constant(tilt / std::sqrt(2.0));
    tilted[axis] = std::copysign(1.0, omega[axis]);
    return omega.norm() * tilted.normalized();
}

/// Throws the body with `omega`, rad/s in its own axes, and steps it by `rule` for `seconds`, or
/// for `most_steps` if these are over before.
template <class Rule>
Thrown throw_body(const Rule& rule, const PrincipalInertia<double>& inertia,
                  const Vector3<double>& omega, Frames frames, double seconds = 10,
                  long most_steps = 60'000) {
    const double orientation_seconds = 2, spin = omega.norm();
    const PrincipalInertia<double> body = inertia.scaled_to_one();
    const SpinState<double> start{0, Quaternion<double>::Identity(), omega};
    const ExactFreeBody<double> exact(body, in_world(start));
    const auto mine = detail::prepared(rule, body);
    const double energy = kinetic_energy(body, omega), between = orientation_seconds / 30;
    const bool known =
        detail::exact_is_known(inertia, spin * std::max(orientation_seconds, frames.longest()));
    const int axis = axis_of_revolution(inertia);
    Thrown thrown;
    if (!known) thrown.off = std::numeric_limits<double>::quiet_NaN();
    if (!known || axis < 0) thrown.axis_off = std::numeric_limits<double>::quiet_NaN();
    SpinState<double> s = start;
    double look = between;
    const double end = seconds - frames.longest() / 2;  // so that steps of 1/60 s are 600
    for (long n = 0; n < most_steps && (n == 0 || s.t < end); ++n) {
        const double h = frames();
        s = rule.step(mine, s, h);
        thrown.energy = kinetic_energy(body, s.omega) / energy;
        if (!(thrown.energy < 1e300) || !is_finite(s)) {
            thrown.energy = thrown.most_energy = std::numeric_limits<double>::infinity();
            thrown.lost = s.t < orientation_seconds;
            if (thrown.lost) thrown.off = 2;
            if (thrown.lost && axis >= 0) thrown.axis_off = 2;
            break;
        }
        thrown.most_energy = std::max(thrown.most_energy, thrown.energy);
        if (known && (n == 0 || (s.t >= look && s.t <= orientation_seconds + h / 2))) {
            const Quaternion<double> truth = exact(s.t).q;
            thrown.off = std::max(thrown.off, apart(s.q, truth));
            if (axis >= 0) {
                const Vector3<double> along = Vector3<double>::Unit(axis);
                thrown.axis_off = std::max(thrown.axis_off, (s.q * along - truth * along).norm());
            }
            while (look <= s.t) look += between;
        }
    }
    thrown.seconds = s.t;
    thrown.spin_left = s.omega.dot(omega) / spin / spin;
    thrown.lost = thrown.lost || (axis < 0 ? thrown.off : thrown.axis_off) > lost_orientation;
    return thrown;
}

/// The exact motion after so many seconds, as a throw.
TIMESTEP_WHERE_CALLED
Thrown throw_exactly(const PrincipalInertia<double>& inertia, const Vector3<double>& omega,
                     double seconds = 10) {
    const PrincipalInertia<double> body = inertia.scaled_to_one();
    const ExactFreeBody<double> exact(body,
                                      RigidState<double>{0, Quaternion<double>::Identity(), omega});
    Thrown thrown;
    thrown.seconds = seconds;
    const bool known = detail::exact_is_known(inertia, omega.norm() * seconds);
    thrown.spin_left = known ? in_body(exact(seconds)).omega.dot(omega) / omega.squaredNorm()
                             : std::numeric_limits<double>::quiet_NaN();
    return thrown;
}

}  // namespace timestep
