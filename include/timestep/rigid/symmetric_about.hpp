#pragma once
/// \file
/// A symmetric body whose odd axis is x or y.

#include <timestep/inline.hpp>
#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// An axis of the body.
enum class Axis { x, y, z };

/// A SymmetricInertia about another axis than z. Engines differ in the axis of a capsule: y in
/// Bullet (its `btCapsuleShape`) and Jolt, z in ODE and here, x in PhysX; in Box3D any two points.
///
///     const auto pill = about<Axis::y>(capsule(mass, radius, length));
///
/// The axis is part of the type, and the formulas are those for z: a cyclic change of the axes'
/// names costs nothing.
template <Axis axis, class Real>
struct SymmetricAbout {
    using Scalar = Real;                          ///< the real number type
    static constexpr bool gyroscopic = true;      ///< whether the body has a gyroscopic torque
    static constexpr int odd = int(axis);         ///< the number of that axis
    static constexpr int first = (odd + 1) % 3;   ///< the axis that stands for x
    static constexpr int second = (odd + 2) % 3;  ///< the axis that stands for y
    SymmetricInertia<Real> about_z;               ///< this body with its odd axis called z

    /// A vector of the body in the axes of `about_z`.
    static Vector3<Real> to_z(const Vector3<Real>& v) { return {v[first], v[second], v[odd]}; }
    /// A vector in the axes of `about_z` in those of the body.
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

/// The steps that a solver takes for bodies in other axes than those of its formulas: a symmetric
/// body about x or y, and a full matrix by way of its principal axes. A solver inherits them and
/// names them, `using InOtherAxes<Solver>::step;`; a formula of its own for a full matrix takes
/// precedence.
template <class Solver>
struct InOtherAxes {
    /// One step of `h` seconds of a symmetric body about x or y; `omega` in body coordinates,
    /// rad/s.
    template <Axis axis, class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const SymmetricAbout<axis, Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        return inertia.from_z(solver().step(inertia.about_z, inertia.to_z(omega), h));
    }

    /// One step of `h` seconds of a body with a full matrix, there and back by way of its principal
    /// axes; `omega` in body coordinates, rad/s.
    template <class Real>
    [[nodiscard]] TIMESTEP_INLINE Vector3<Real> step(const FullInertia<Real>& inertia,
                                                     const Vector3<Real>& omega,
                                                     Real h) const noexcept {
        const Vector3<Real> principal = in_body(inertia.axes, omega);
        return in_world(inertia.axes, solver().step(inertia.principal, principal, h));
    }

private:
    TIMESTEP_INLINE const Solver& solver() const noexcept {
        return static_cast<const Solver&>(*this);
    }
};

}  // namespace timestep
