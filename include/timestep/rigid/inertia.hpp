#pragma once
/// \file
/// Inertia is a type: it says what the gyroscopic torque ω × Iω of a body needs, and nothing more
/// is compiled.
///
///     UniformInertia     sphere, cube          no gyroscopic torque
///     RodInertia         a line of mass        none either, and no spin about the line
///     SymmetricInertia   capsule, cylinder     two equal moments: closed forms
///     PrincipalInertia   box                   three moments along the axes of the body
///     FullInertia        any body, any axes    a symmetric matrix
///
/// All are in body coordinates, about the centre of mass, in kg m². They are checked here, once.

#include <algorithm>
#include <cstdio>
#include <limits>

#include <timestep/checks.hpp>
#include <timestep/eigenvectors.hpp>
#include <timestep/rigid/rotation.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// \cond
namespace detail {
template <class Real>
constexpr bool is_positive(Real I) {
    return is_finite_parameter(I) && I > 0;
}

// Mass is never negative, so no moment exceeds the sum of the other two: with moments
// ∫(y² + z²), ∫(z² + x²), ∫(x² + y²) the difference is twice ∫x², ∫y² or ∫z². An exact plate has
// equality, so roundoff is allowed for.
template <class Real>
constexpr bool is_triangle(Real I1, Real I2, Real I3) {
    const Real allowance = 1 + 8 * std::numeric_limits<Real>::epsilon();
    const Real largest = std::max({I1, I2, I3});
    const Real others = largest == I1 ? I2 + I3 : largest == I2 ? I3 + I1 : I1 + I2;
    return largest <= others * allowance;
}
// With the sum, and by how much it is too large: of 2.0000001 the first digits tell nothing.
[[noreturn]] inline void refuse_triangle(double largest, double others) {
    const char* rule = "at most the sum of the other two moments";
#if defined(TIMESTEP_REFUSED_BRIEFLY)
    static_cast<void>(largest), static_cast<void>(others);
    refuse(rule);
#else
    char line[256];
    std::snprintf(line, sizeof line,
                  "moment of inertia = %.9g: must be %s, %.9g; it exceeds that by %.3g", largest,
                  rule, others, largest - others);
    refuse(line);
#endif
}
template <class Real>
constexpr void triangle_rule(Real a, Real b, Real c) {
    for_each_number(
        [](auto I1, auto I2, auto I3) {
            if (is_triangle(I1, I2, I3)) return;
            const double x = double(I1), y = double(I2), z = double(I3),
                         largest = std::max({x, y, z});
            refuse_triangle(largest, largest == x ? y + z : largest == y ? z + x : x + y);
        },
        a, b, c);
}

// The solvers compute with the moments over their geometric mean, and divide by them. Moments that
// are further apart than numbers reach have none, and of subnormal moments it has lost digits: then
// the product is not one. (64 ε is what three cube roots may be off by, cubed.)
template <class Real>
bool is_comparable(Real I1, Real I2, Real I3) {
    return is_finite_parameter(std::max({I1, I2, I3}) / std::min({I1, I2, I3}));
}
template <class Real>
bool is_one(Real product) {
    return std::abs(product - 1) <= 64 * std::numeric_limits<Real>::epsilon();
}
template <class Real>
void scale_rule(const Vector3<Real>& moments, const Vector3<Real>& unit) {
    for_each_number(
        [](auto I1, auto I2, auto I3, auto U1, auto U2, auto U3) {
            const auto least = std::min({I1, I2, I3});
            if (!is_comparable(I1, I2, I3))
                refuse("moment of inertia", least, "so large that the largest over it is finite");
            if (!is_one(U1 * U2 * U3))
                refuse("moment of inertia", least,
                       "such that the moments over their geometric mean have the product one");
        },
        moments.x(), moments.y(), moments.z(), unit.x(), unit.y(), unit.z());
}
}  // namespace detail
/// \endcond

/// The same moment about every axis: Iω points along ω, and the gyroscopic torque vanishes (N41).
template <class Real>
struct UniformInertia {
    using Scalar = Real;                       ///< the real number type
    static constexpr bool gyroscopic = false;  ///< has the body a gyroscopic torque at all?
    Real moment;                               ///< about any axis, kg m²

    /// Is there a body with this moment? What the constructor takes, and without an exception.
    static constexpr bool valid(Real moment_) noexcept { return detail::is_positive(moment_); }

    /// `moment` in kg m², above zero. Throws `std::invalid_argument`.
    explicit constexpr UniformInertia(Real moment_)
        : moment(positive("moment of inertia", moment_)) {}

    /// Angular momentum Iω, kg m²/s.
    Vector3<Real> momentum(const Vector3<Real>& omega) const { return moment * omega; }
    /// The angular velocity of the angular momentum L, I⁻¹L, rad/s.
    Vector3<Real> velocity(const Vector3<Real>& L) const { return L / moment; }
};

/// A line of mass along the body's z axis. It has no moment about that axis and cannot be said to
/// spin about it: that component of ω is always zero, and with it the gyroscopic torque.
template <class Real>
struct RodInertia {
    using Scalar = Real;                       ///< the real number type
    static constexpr bool gyroscopic = false;  ///< ω × Iω = 0 while ω_z = 0
    Real moment;                               ///< about any axis across the rod, kg m²

    /// Is there a body with this moment? What the constructor takes, and without an exception.
    static constexpr bool valid(Real moment_) noexcept { return detail::is_positive(moment_); }

    /// `moment` in kg m², above zero. Throws `std::invalid_argument`.
    explicit constexpr RodInertia(Real moment_) : moment(positive("moment of inertia", moment_)) {}

    /// Angular momentum Iω, kg m²/s.
    Vector3<Real> momentum(const Vector3<Real>& omega) const {
        return {moment * omega.x(), moment * omega.y(), Real(0)};
    }
    /// The angular velocity of the angular momentum L, rad/s; what L has along the rod is dropped.
    Vector3<Real> velocity(const Vector3<Real>& L) const {
        return {L.x() / moment, L.y() / moment, Real(0)};
    }
};

/// Two equal moments: a body of revolution about its z axis, or any rod with a square profile.
template <class Real>
struct SymmetricInertia {
    using Scalar = Real;                      ///< the real number type
    static constexpr bool gyroscopic = true;  ///< has the body a gyroscopic torque at all?
    Real across;                              ///< about x, y and every axis between, kg m²
    Real along;                               ///< about z, kg m²
    Real precession_ratio;                    ///< (along − across) / across: see rate()

    /// Is there a body with these moments? What the constructor takes, and without an exception.
    static constexpr bool valid(Real across_, Real along_) noexcept {
        return detail::is_positive(across_) && detail::is_positive(along_) &&
               detail::is_triangle(across_, across_, along_);
    }

    /// Moments in kg m², above zero, `along` at most 2 `across`. Throws `std::invalid_argument`.
    /// Where the odd axis is x or y, see about(); where it is known only when the body is loaded,
    /// AnyInertia.
    constexpr SymmetricInertia(Real across_, Real along_)
        : across(positive("moment of inertia", across_)),
          along(positive("moment of inertia", along_)),
          precession_ratio((along - across) / across) {
        detail::triangle_rule(across, across, along);
    }

    /// Angular momentum Iω, kg m²/s.
    Vector3<Real> momentum(const Vector3<Real>& omega) const {
        return {across * omega.x(), across * omega.y(), along * omega.z()};
    }
    /// The angular velocity of the angular momentum L, I⁻¹L, rad/s.
    Vector3<Real> velocity(const Vector3<Real>& L) const {
        return {L.x() / across, L.y() / across, L.z() / along};
    }
};

/// Three moments along the body's axes x, y and z.
///
/// Only their ratios move a free body, so the solvers use the moments over their geometric mean:
/// three numbers whose product is one. They are made here, once, and a body of a milligram is as
/// good as one of a ton, in `float` too.
template <class Real>
struct PrincipalInertia {
    static_assert(!std::is_integral_v<Real>,
                  "timestep: parameters are real numbers: write 1.0 instead of 1");
    using Scalar = Real;                      ///< the real number type
    static constexpr bool gyroscopic = true;  ///< has the body a gyroscopic torque at all?
    Vector3<Real> moments;                    ///< I₁, I₂, I₃, kg m²
    Vector3<Real> unit;  ///< U₁, U₂, U₃ = I₁, I₂, I₃ over ∛(I₁I₂I₃)
    Vector3<Real> ratio;  ///< a₁ = (I₃ − I₂)/I₁ and so on round: ω̇₁ = −a₁ ω₂ ω₃

    /// Is there a body with these moments? What the constructor takes, and without an exception.
    static bool valid(Real I1, Real I2, Real I3) noexcept {
        using detail::is_positive;
        if (!(is_positive(I1) && is_positive(I2) && is_positive(I3))) return false;
        const Vector3<Real> unit = over_their_mean(Vector3<Real>(I1, I2, I3));
        return detail::is_triangle(I1, I2, I3) && detail::is_comparable(I1, I2, I3) &&
               detail::is_one(unit.x() * unit.y() * unit.z());
    }

    /// Moments in kg m², above zero, none larger than the sum of the others; the ratio of any two,
    /// and their geometric mean, must be numbers that `Real` can hold with all digits.
    /// Throws `std::invalid_argument`.
    PrincipalInertia(Real I1, Real I2, Real I3) : moments(I1, I2, I3) {
        for (const Real I : {I1, I2, I3}) positive("moment of inertia", I);
        detail::triangle_rule(I1, I2, I3);
        ratio = {(I3 - I2) / I1, (I1 - I3) / I2, (I2 - I1) / I3};
        unit = over_their_mean(moments);
        detail::scale_rule(moments, unit);
    }

    /// Angular momentum Iω, kg m²/s.
    Vector3<Real> momentum(const Vector3<Real>& omega) const { return moments.cwiseProduct(omega); }
    /// The angular velocity of the angular momentum L, I⁻¹L, rad/s.
    Vector3<Real> velocity(const Vector3<Real>& L) const { return L.cwiseQuotient(moments); }

private:
    static Vector3<Real> over_their_mean(const Vector3<Real>& I) noexcept {
        return I / (cube_root(I.x()) * cube_root(I.y()) * cube_root(I.z()));
    }
};

/// A symmetric matrix: the inertia in whatever axes the modeller has used. It knows its principal
/// axes. A game turns the body's frame into them once, when it loads the body, and uses
/// PrincipalInertia from then on; the full matrix costs more in every step.
template <class Real>
struct FullInertia {
    using Scalar = Real;                      ///< the real number type
    static constexpr bool gyroscopic = true;  ///< has the body a gyroscopic torque at all?
    Matrix3<Real> matrix;                     ///< kg m²
    Matrix3<Real> unit;     ///< the matrix over a power of two, its largest number 1 to 2
    Matrix3<Real> inverse;  ///< its inverse
    Matrix3<Real> axes;     ///< the principal axes, in its columns
    PrincipalInertia<Real> principal;  ///< the moments about those axes

    /// Is there a body with this matrix? What the constructor takes, and without an exception.
    static bool valid(const Matrix3<Real>& I) noexcept {
        if (!is_finite(I) || !is_symmetric(I)) return false;
        Matrix3<Real> turned = I;
        const Matrix3<Real> axes = eigenvectors(turned);
        const Vector3<Real> found = turned.diagonal(), m = no_thinner_than_a_plate(found);
        return is_known(found) && PrincipalInertia<Real>::valid(m.x(), m.y(), m.z()) &&
               is_finite(inverse_of(axes, m));
    }

    /// A symmetric matrix in kg m² whose eigenvalues are what PrincipalInertia asks for, none below
    /// 100 ε of the largest: in `float` a needle's least moment must be 1e-5 of its others or more.
    /// Its inverse must be finite. Throws `std::invalid_argument`.
    explicit FullInertia(const Matrix3<Real>& I) : FullInertia(checked(I), Matrix3<Real>(I)) {}

    /// Angular momentum Iω, kg m²/s.
    Vector3<Real> momentum(const Vector3<Real>& omega) const { return times(matrix, omega); }
    /// The angular velocity of the angular momentum L, I⁻¹L, rad/s.
    Vector3<Real> velocity(const Vector3<Real>& L) const { return times(inverse, L); }

private:
    // `turned` is the matrix, to be seen from its principal axes.
    FullInertia(const Matrix3<Real>& I, Matrix3<Real> turned)
        : matrix(I), axes(eigenvectors(turned)), principal(of(turned.diagonal())) {
        if (axes.determinant() < 0) axes.col(0) = -axes.col(0);  // a rotation, no reflection
        unit = matrix / std::exp2(Real(std::ilogb(matrix.cwiseAbs().maxCoeff())));
        inverse = inverse_of(axes, principal.moments);
        if (!is_finite(inverse))
            refuse("least moment of inertia", principal.moments.minCoeff(),
                   "so large that the inverse of the matrix is finite");
    }
    static const Matrix3<Real>& checked(const Matrix3<Real>& I) {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) finite("inertia", I(i, j));
        if (!is_symmetric(I))
            refuse("inertia's asymmetry", asymmetry(I), "zero: the matrix equals its transpose");
        return I;
    }
    static Real asymmetry(const Matrix3<Real>& I) {
        return (I - I.transpose()).cwiseAbs().maxCoeff();
    }
    static bool is_symmetric(const Matrix3<Real>& I) {
        return !(asymmetry(I) > 8 * std::numeric_limits<Real>::epsilon() * I.cwiseAbs().maxCoeff());
    }
    static Matrix3<Real> inverse_of(const Matrix3<Real>& axes, const Vector3<Real>& moments) {
        return times(Matrix3<Real>(axes * moments.cwiseInverse().asDiagonal()),
                     Matrix3<Real>(axes.transpose()));
    }
    // From the eigenvalues, rising. Each is off by as much as the matrix at the worst (Weyl), and
    // that is some ε of the LARGEST: up to 4 ε by the products that turned the body into these
    // axes, and up to 3 ε by the solver. (So much was seen in a million bodies.)
    //
    // A plate has I₃ = I₁ + I₂. What it seems to have more, 2I₃ minus the trace, is at most twice
    // that error; 32 ε are taken off, in case there are worse bodies. A least moment of 100 ε is
    // known to a sixth; of a smaller one no digit would be right, and the body would wobble by
    // chance.
    static bool is_known(const Vector3<Real>& I) {
        return !(std::abs(I.x()) < 100 * (std::numeric_limits<Real>::epsilon() * I.z()));
    }
    static Vector3<Real> no_thinner_than_a_plate(const Vector3<Real>& I) {
        const Real others = I.x() + I.y(), roundoff = std::numeric_limits<Real>::epsilon() * I.z();
        return {I.x(), I.y(), I.z() > others + 32 * roundoff ? I.z() : std::min(I.z(), others)};
    }
    static PrincipalInertia<Real> of(const Vector3<Real>& I) {
        if (!is_known(I))
            refuse("least moment of inertia", I.x(),
                   "100 roundoffs of the largest or more, or no digit of it is right: give "
                   "PrincipalInertia its moments, or use double");
        const Vector3<Real> m = no_thinner_than_a_plate(I);
        return {m.x(), m.y(), m.z()};
    }
};

/// The kinetic energy ½ ω·Iω, J; `omega` in body coordinates, rad/s.
template <class Inertia>
typename Inertia::Scalar kinetic_energy(const Inertia& inertia,
                                        const Vector3<typename Inertia::Scalar>& omega) {
    return dot(omega, inertia.momentum(omega)) / 2;
}

}  // namespace timestep
