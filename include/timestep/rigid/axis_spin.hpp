#pragma once
/// \file
/// A turn about one axis of the body: what splittings are made of.

#include <timestep/inline.hpp>
#include <timestep/own_math.hpp>
#include <timestep/rigid/rotation.hpp>

namespace timestep {

/// Orientation and angular momentum of a body that turns about one of its axes after the other.
template <class Real>
struct AxisSpin {
    Quaternion<Real> q;  ///< orientation
    Vector3<Real> L;     ///< angular momentum in body coordinates

    // The sine and cosine of half the angle do for both: the quaternion takes half angles, and
    // cos θ = 1 − 2 s², sin θ = 2 s c. What changes is added to what is there: of a small angle the
    // rounded cosine is a bare one, and a turn by that and the sine stretches L a little each time,
    // in float by a percent in an hour.
    /// Turns the body by `angle` about its axis `i` = 0, 1 or 2. L, at rest in the world, turns the
    /// other way in the body.
    /// [spin]
    TIMESTEP_INLINE void spin(int i, Real angle) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const auto [s, c] = sine_cosine(angle / 2);
        const Real less = 2 * s * s, sine = 2 * s * c;  // 1 − cos θ, sin θ
        const Real Lj = L[j], Lk = L[k];
        L[j] += sine * Lk - less * Lj;
        L[k] -= sine * Lj + less * Lk;
        auto& v = q.coeffs();  // x, y, z, w: v times (c, s along i)
        const Real w = v[3], vi = v[i], vj = v[j], vk = v[k];
        v[3] = c * w - s * vi;
        v[i] = c * vi + s * w;
        v[j] = c * vj + s * vk;
        v[k] = c * vk - s * vj;
    }
    /// [spin]
};

}  // namespace timestep
