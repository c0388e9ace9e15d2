#pragma once
/// \file
/// A symmetric body whose odd axis is x or y.

#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// An axis of the body.
enum class Axis { x, y, z };

/// A SymmetricInertia about another axis than z. Engines differ in where a capsule lies: along y in
/// Bullet (its `btCapsuleShape`) and Jolt, along z in ODE and here, along x in PhysX; in Box3D
/// between any two points.
///
///     const auto pill = about<Axis::y>(capsule(mass, radius, length));
///
/// The axis is part of the type, and the formulas are those for z: a cyclic change of the axes'
/// names costs nothing.
template <Axis axis, class Real>
struct SymmetricAbout {
    using Scalar = Real;                          ///< the real number type
    static constexpr bool gyroscopic = true;      ///< has the body a gyroscopic torque at all?
    static constexpr int odd = int(axis);         ///< the number of that axis
    static constexpr int first = (odd + 1) % 3;   ///< which stands for x
    static constexpr int second = (odd + 2) % 3;  ///< which stands for y
    SymmetricInertia<Real> about_z;               ///< the same body, its odd axis called z

    /// A vector of the body in the axes of `about_z`.
    static Vector3<Real> to_z(const Vector3<Real>& v) { return {v[first], v[second], v[odd]}; }
    /// And back.
    static Vector3<Real> from_z(const Vector3<Real>& v) {
        Vector3<Real> back;
        back[first] = v.x(), back[second] = v.y(), back[odd] = v.z();
        return back;
    }
    /// The three moments, kg m².
    Vector3<Real> moments() const {
        return from_z({about_z.across, about_z.across, about_z.along});
    }
    /// Angular momentum Iω, kg m²/s.
    Vector3<Real> momentum(const Vector3<Real>& omega) const {
        return moments().cwiseProduct(omega);
    }
    /// The angular velocity of the angular momentum L, I⁻¹L, rad/s.
    Vector3<Real> velocity(const Vector3<Real>& L) const { return L.cwiseQuotient(moments()); }
};

/// The body with its axis of symmetry along `axis` instead of z.
template <Axis axis, class Real>
constexpr SymmetricAbout<axis, Real> about(const SymmetricInertia<Real>& along_z) {
    return {along_z};
}

}  // namespace timestep
