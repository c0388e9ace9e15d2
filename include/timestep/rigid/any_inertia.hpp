#pragma once
/// \file
/// A body whose kind of inertia is known only at run time: three moments pick it.

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

#include <timestep/rigid/symmetric_about.hpp>

namespace timestep {

/// The inertia of three moments along the body's axes: a ball's (all equal), a symmetric body's
/// (two equal; any axis may be the odd one) or a box's. Moments that differ by at most eight
/// roundoffs count as equal.
///
/// Every step branches on the kind. If that costs too much, sort bodies by kind (Bodies) instead.
template <class Real>
class AnyInertia {
public:
    using Scalar = Real;  ///< the real number type
    /// Whether the constructor takes these moments.
    [[nodiscard]] static bool valid(const Vector3<Real>& moments) {
        return PrincipalInertia<Real>::valid(moments.x(), moments.y(), moments.z());
    }

    /// Moments about x, y and z, kg m², as PrincipalInertia takes them. Throws
    /// `std::invalid_argument`.
    explicit AnyInertia(const Vector3<Real>& moments) : kind_(picked(moments)) {}

    /// The kinds that may be picked.
    using Kind =
        std::variant<UniformInertia<Real>, SymmetricAbout<Axis::x, Real>,
                     SymmetricAbout<Axis::y, Real>, SymmetricInertia<Real>, PrincipalInertia<Real>>;
    /// The kind that was picked.
    const Kind& kind() const { return kind_; }

    /// One gyroscopic step of `h` seconds by `solver`, with the formula of the kind; `omega` in the
    /// body's axes, rad/s.
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
        const PrincipalInertia<Real> checked(I.x(), I.y(), I.z());  // throws if they are no body's
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
