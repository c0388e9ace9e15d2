#pragma once
/// \file
/// A body whose kind is known only when it is loaded: three moments pick it.

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

#include <timestep/rigid/symmetric_about.hpp>

namespace timestep {

/// The inertia that three moments along the body's axes ask for: a ball's (all equal), a symmetric
/// body's (two equal, and any axis may be the odd one) or a box's. Two that differ by at most eight
/// roundoffs are equal.
///
/// The kind is asked in every step. Where it matters, sort bodies by kind (Bodies) instead.
template <class Real>
class AnyInertia {
public:
    using Scalar = Real;  ///< the real number type
    /// Is there a body with these moments? What the constructor takes, and without an exception.
    static bool valid(const Vector3<Real>& moments) {
        return PrincipalInertia<Real>::valid(moments.x(), moments.y(), moments.z());
    }

    /// Moments about x, y and z, kg m², as PrincipalInertia takes them. Throws
    /// `std::invalid_argument`.
    explicit AnyInertia(const Vector3<Real>& moments) : kind_(picked(moments)) {}

    /// What may be picked.
    using Kind =
        std::variant<UniformInertia<Real>, SymmetricAbout<Axis::x, Real>,
                     SymmetricAbout<Axis::y, Real>, SymmetricInertia<Real>, PrincipalInertia<Real>>;
    /// Which was.
    const Kind& kind() const { return kind_; }

    /// One gyroscopic step by `solver`, `omega` in the body's axes, rad/s, with the formula of the
    /// kind.
    template <class Gyroscopic>
    Vector3<Real> step(const Gyroscopic& solver, const Vector3<Real>& omega, Real h) const {
        return std::visit(
            [&](const auto& inertia) -> Vector3<Real> {
                if constexpr (std::decay_t<decltype(inertia)>::gyroscopic)
                    return solver.step(inertia, omega, h);
                else
                    return omega;
            },
            kind_);
    }

private:
    static bool equal(Real a, Real b) {
        return std::abs(a - b) <= 8 * std::numeric_limits<Real>::epsilon() * std::max(a, b);
    }
    static Kind picked(const Vector3<Real>& I) {
        const PrincipalInertia<Real> checked(I.x(), I.y(), I.z());  // refuses what is none
        const bool xy = equal(I.x(), I.y()), yz = equal(I.y(), I.z()), zx = equal(I.z(), I.x());
        if (xy && zx) return UniformInertia<Real>(I.x());
        if (xy) return SymmetricInertia<Real>(I.x(), I.z());
        if (yz) return about<Axis::x>(SymmetricInertia<Real>(I.y(), I.x()));
        if (zx) return about<Axis::y>(SymmetricInertia<Real>(I.z(), I.y()));
        return checked;
    }

    Kind kind_;
};

}  // namespace timestep
