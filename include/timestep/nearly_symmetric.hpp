#pragma once
/// \file
/// Bodies with two nearly equal moments: the step if a game declares the moments equal, and the
/// loss if it does not.

#include <cmath>
#include <limits>

#include <timestep/body_throw.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/inline.hpp>

namespace timestep {

/// The passive step of a body whose two closest moments are declared equal, in any order of the
/// axes; the mean of the old and the new ω rotates it.
class DeclaredEqual {
public:
    static constexpr const char* name = "declared equal";  ///< for tables and keys
    /// Prepares the step of any body.
    explicit DeclaredEqual(const PrincipalInertia<double>& inertia)
        : odd_(closest_moments(inertia).odd), equal_(declared(inertia)) {}

    /// One step of `h` seconds. The inertia is that of the constructor.
    SpinState<double> step(const PrincipalInertia<double>&, const SpinState<double>& s,
                           double h) const {
        const int i = (odd_ + 1) % 3, j = (odd_ + 2) % 3;
        const Vector3<double> along_z(s.omega[i], s.omega[j], s.omega[odd_]);
        const Vector3<double> after = passive_gyroscopic.step(equal_, along_z, h);
        Vector3<double> omega;
        omega[i] = after.x(), omega[j] = after.y(), omega[odd_] = after.z();
        return {s.t + h, rotated_in_body(s.q, Vector3<double>(s.omega / 2 + omega / 2), h), omega};
    }

private:
    static SymmetricInertia<double> declared(const PrincipalInertia<double>& inertia) {
        const ClosestMoments closest = closest_moments(inertia.scaled_to_one());
        return {closest.equal[std::size_t((closest.odd + 1) % 3)],
                closest.equal[std::size_t(closest.odd)]};
    }
    int odd_;
    SymmetricInertia<double> equal_;
};

/// The time, s, after which the passive step has halved the spin about the axis of the odd moment,
/// for a body spun about it at `spin` rad/s and tilted by a hundredth. Infinite if that takes
/// longer than an hour or a million steps.
TIMESTEP_WHERE_CALLED
double half_gone_by_passive(const PrincipalInertia<double>& inertia, double spin, Frames frames) {
    const int odd = closest_moments(inertia).odd;
    Vector3<double> omega = as_thrown(Vector3<double>(spin * Vector3<double>::Unit(odd)));
    const double half = omega[odd] / 2;
    double t = 0;
    for (long n = 0; n < 1'000'000 && t < 3600; ++n) {
        const double h = frames();
        omega = passive_gyroscopic.step(inertia, omega, h);
        t += h;
        if (!(omega[odd] > half)) return t;
    }
    return std::numeric_limits<double>::infinity();
}

}  // namespace timestep
