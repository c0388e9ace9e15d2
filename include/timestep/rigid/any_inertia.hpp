#pragma once
/// \file
/// A body whose kind is known only when it is loaded: three moments pick it.

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// The inertia that three moments along the body's axes ask for: a ball's (all equal), a symmetric body's (two equal,
/// and any axis may be the odd one) or a box's. Two that differ by at most eight roundoffs are equal.
///
/// The kind is asked in every step. Where it matters, sort bodies by kind (Bodies) instead.
template <class Real>
class AnyInertia {
public:
    using Scalar = Real;  ///< the real number type
    /// Is there a body with these moments? What the constructor takes, and without an exception.
    static bool valid(const Vector3<Real>& moments) {
        const Real largest = moments.maxCoeff(), least = moments.minCoeff();
        const Real roundoff = 8 * std::numeric_limits<Real>::epsilon();
        using std::cbrt;  // the product of the moments' roots is a number, too
        const Real mean = cbrt(moments.x()) * cbrt(moments.y()) * cbrt(moments.z());
        return moments.allFinite() && std::isfinite(mean) && least >= std::numeric_limits<Real>::min() &&
               largest / least <= std::numeric_limits<Real>::max() &&
               largest <= (moments.sum() - largest) * (1 + roundoff);
    }

    /// Moments about x, y and z, kg m², as PrincipalInertia takes them. Throws `std::invalid_argument`.
    explicit AnyInertia(const Vector3<Real>& moments) : odd_(odd_axis(moments)), kind_(picked(moments, odd_)) {}

    /// Which kind was picked: UniformInertia, SymmetricInertia or PrincipalInertia.
    const std::variant<UniformInertia<Real>, SymmetricInertia<Real>, PrincipalInertia<Real>>& kind() const {
        return kind_;
    }
    /// The axis of the odd moment, 0, 1 or 2, of a symmetric body; otherwise 2.
    int odd() const { return odd_; }

    /// One gyroscopic step by `solver`, `omega` in the body's axes, rad/s, with the formula of the kind.
    template <class Gyroscopic>
    Vector3<Real> step(const Gyroscopic& solver, const Vector3<Real>& omega, Real h) const {
        return std::visit([&](const auto& inertia) { return step(solver, inertia, omega, h); }, kind_);
    }

private:
    template <class Gyroscopic, class Inertia>
    Vector3<Real> step(const Gyroscopic& solver, const Inertia& inertia, const Vector3<Real>& omega, Real h) const {
        if constexpr (!Inertia::gyroscopic) {
            return omega;
        } else {  // a cyclic change of axes brings the odd one to z, and back
            const int i = (odd_ + 1) % 3, j = (odd_ + 2) % 3;
            const Vector3<Real> after = solver.step(inertia, Vector3<Real>(omega[i], omega[j], omega[odd_]), h);
            Vector3<Real> back;
            back[i] = after.x(), back[j] = after.y(), back[odd_] = after.z();
            return back;
        }
    }
    static bool equal(Real a, Real b) {
        return std::abs(a - b) <= 8 * std::numeric_limits<Real>::epsilon() * std::max(a, b);
    }
    static int odd_axis(const Vector3<Real>& I) {
        return equal(I.x(), I.y()) ? 2 : equal(I.y(), I.z()) ? 0 : equal(I.z(), I.x()) ? 1 : 2;
    }
    static std::variant<UniformInertia<Real>, SymmetricInertia<Real>, PrincipalInertia<Real>> picked(
        const Vector3<Real>& I, int odd) {
        const PrincipalInertia<Real> checked(I.x(), I.y(), I.z());  // refuses what is none
        const Real across = I[(odd + 1) % 3];
        if (!equal(across, I[(odd + 2) % 3])) return checked;
        if (equal(across, I[odd])) return UniformInertia<Real>(across);
        return SymmetricInertia<Real>(across, I[odd]);
    }

    int odd_;
    std::variant<UniformInertia<Real>, SymmetricInertia<Real>, PrincipalInertia<Real>> kind_;
};

}  // namespace timestep
