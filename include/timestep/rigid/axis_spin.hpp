#pragma once
/// \file
/// A rotation about one axis of the body: the part from which splittings are built.

#include <timestep/inline.hpp>
#include <timestep/own_math.hpp>
#include <timestep/rigid/rotation.hpp>

namespace timestep {

/// Orientation and angular momentum of a body that rotates about one of its axes after another.
template <class Real>
struct AxisSpin {
    Quaternion<Real> q;  ///< orientation
    Vector3<Real> L;     ///< angular momentum in body coordinates

    // The sine and cosine of half the angle serve both: the quaternion needs half angles, and
    // cos θ = 1 − 2 s², sin θ = 2 s c. Only the change is added to L: the cosine of a small angle
    // rounds to one, and a rotation with that cosine stretches L a little each time, in `float` by
    // a percent per hour.
    /// Rotates the body by `angle`, rad, about its axis `i` = 0, 1 or 2. L, constant in the world,
    /// rotates the other way in the body.
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
