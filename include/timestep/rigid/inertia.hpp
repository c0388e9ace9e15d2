#pragma once
/// \file
/// Inertia is a type: it determines what the gyroscopic torque ω × Iω of a body needs, and nothing
/// more is compiled.
///
///     UniformInertia     sphere, cube          no gyroscopic torque
///     RodInertia         a line of mass        none either, and no spin about the line
///     SymmetricInertia   capsule, cylinder     two equal moments: closed forms
///     PrincipalInertia   box                   three moments along the axes of the body
///     FullInertia        any body, any axes    a symmetric matrix
///
/// All are in body coordinates, about the centre of mass, in kg m². Each checks its moments once,
/// in its constructor.

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>

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

// The first rule that an inertia breaks: no rule if it breaks none.
struct InertiaFault {
    const char* name = "";
    double value = 0;
    const char* rule = nullptr;
    double others = 0;  // of the triangle rule: the sum of the other two moments
};

// With the sum, and the excess: of 2.0000001 the first digits show nothing.
[[noreturn]] inline void refuse_fault(const InertiaFault& fault) {
#if !defined(TIMESTEP_REFUSED_BRIEFLY)
    if (fault.others > 0) {
        char line[256];
        std::snprintf(line, sizeof line, "%s = %.9g: must be %s, %.9g; it exceeds that by %.3g",
                      fault.name, fault.value, fault.rule, fault.others,
                      fault.value - fault.others);
        refuse(line);
    }
#endif
    refuse(fault.name, fault.value, fault.rule);
}

// Mass is never negative, so no moment exceeds the sum of the other two: with moments
// ∫(y² + z²), ∫(z² + x²), ∫(x² + y²) the difference is twice ∫x², ∫y² or ∫z². An exact plate has
// equality, so roundoff is allowed for.
template <class Real>
constexpr InertiaFault moments_fault(Real I1, Real I2, Real I3) {
    for (const Real I : {I1, I2, I3})
        if (!is_positive(I))
            return {"moment of inertia", double(I), "finite and greater than zero"};
    const Real allowance = 1 + 8 * std::numeric_limits<Real>::epsilon();
    const Real largest = std::max({I1, I2, I3});
    const Real others = largest == I1 ? I2 + I3 : largest == I2 ? I3 + I1 : I1 + I2;
    if (largest <= others * allowance) return {};
    const double x = double(I1), y = double(I2), z = double(I3), most = double(largest);
    return {"moment of inertia", most, "at most the sum of the other two moments",
            most == x   ? y + z
            : most == y ? z + x
                        : x + y};
}

template <class Real>
Vector3<Real> over_their_mean(const Vector3<Real>& I) noexcept {
    return I / (cube_root(I.x()) * cube_root(I.y()) * cube_root(I.z()));
}

// The solvers compute with the moments over their geometric mean, and divide by them. Moments that
// are further apart than numbers reach have no mean, and the mean of subnormal moments has lost
// digits: then the product is not one. (64 ε is what three cube roots may be off by, cubed.)
template <class Real>
InertiaFault principal_fault(Real I1, Real I2, Real I3) noexcept {
    const InertiaFault fault = moments_fault(I1, I2, I3);
    if (fault.rule) return fault;
    const Real least = std::min({I1, I2, I3});
    if (!is_finite_parameter(std::max({I1, I2, I3}) / least))
        return {"moment of inertia", double(least), "so large that the largest over it is finite"};
    const Vector3<Real> unit = over_their_mean(Vector3<Real>(I1, I2, I3));
    const Real product = unit.x() * unit.y() * unit.z();
    if (!(std::abs(product - 1) <= 64 * std::numeric_limits<Real>::epsilon()))
        return {"moment of inertia", double(least),
                "such that the moments over their geometric mean have the product one"};
    return {};
}

// Gives an object with read-only members another value as a whole.
template <class T>
constexpr T& replace(T& object, const T& other) {
    if (&object == &other) return object;
    std::destroy_at(&object);
    return *std::construct_at(&object, other);
}
}  // namespace detail
/// \endcond

/// One moment about every axis: Iω points along ω, and the gyroscopic torque vanishes (N41).
template <class Real>
struct UniformInertia {
    using Scalar = Real;                       ///< the real number type
    static constexpr bool gyroscopic = false;  ///< whether the body has a gyroscopic torque
    Real moment;                               ///< about any axis, kg m²

    /// Whether the constructor takes this moment.
    [[nodiscard]] static constexpr bool valid(Real moment_) noexcept {
        return detail::is_positive(moment_);
    }

    /// `moment` in kg m², above zero. Throws `std::invalid_argument`.
    explicit constexpr UniformInertia(Real moment_)
        : moment(positive("moment of inertia", moment_)) {}

    /// Angular momentum Iω, kg m²/s.
    Vector3<Real> momentum(const Vector3<Real>& omega) const { return moment * omega; }
    /// The angular velocity of the angular momentum L, I⁻¹L, rad/s.
    Vector3<Real> velocity(const Vector3<Real>& L) const { return L / moment; }
};

/// A line of mass along the body's z axis. It has no moment about that axis and no spin about it:
/// that component of ω is zero, and with it the gyroscopic torque.
template <class Real>
struct RodInertia {
    using Scalar = Real;                       ///< the real number type
    static constexpr bool gyroscopic = false;  ///< ω × Iω = 0 while ω_z = 0
    Real moment;                               ///< about any axis across the rod, kg m²

    /// Whether the constructor takes this moment.
    [[nodiscard]] static constexpr bool valid(Real moment_) noexcept {
        return detail::is_positive(moment_);
    }

    /// `moment` in kg m², above zero. Throws `std::invalid_argument`.
    explicit constexpr RodInertia(Real moment_) : moment(positive("moment of inertia", moment_)) {}

    /// Angular momentum Iω, kg m²/s.
    Vector3<Real> momentum(const Vector3<Real>& omega) const {
        return {moment * omega.x(), moment * omega.y(), Real(0)};
    }
    /// The angular velocity of the angular momentum L, rad/s; the part of L along the rod is
    /// dropped.
    Vector3<Real> velocity(const Vector3<Real>& L) const {
        return {L.x() / moment, L.y() / moment, Real(0)};
    }
};

/// Two equal moments: a body of revolution about its z axis, or any rod with a square profile. The
/// members are read-only; another inertia may be assigned as a whole.
template <class Real>
struct SymmetricInertia {
    using Scalar = Real;                      ///< the real number type
    static constexpr bool gyroscopic = true;  ///< whether the body has a gyroscopic torque
    const Real across;                        ///< about x, y and every axis between, kg m²
    const Real along;                         ///< about z, kg m²
    const Real precession_ratio;              ///< (along − across) / across

    /// Whether the constructor takes these moments.
    [[nodiscard]] static constexpr bool valid(Real across_, Real along_) noexcept {
        return !detail::moments_fault(across_, across_, along_).rule;
    }

    /// Moments in kg m², above zero, `along` at most 2 `across`. Throws `std::invalid_argument`.
    /// If the odd axis is x or y, see about(); if it is known only when the body is loaded,
    /// AnyInertia.
    constexpr SymmetricInertia(Real across_, Real along_)
        : across(across_), along(along_), precession_ratio((along - across) / across) {
        for_each_number(
            [](auto I, auto J) {
                const detail::InertiaFault fault = detail::moments_fault(I, I, J);
                if (fault.rule) detail::refuse_fault(fault);
            },
            across, along);
    }

    constexpr SymmetricInertia(const SymmetricInertia&) = default;  ///< copies
    /// Replaces this inertia.
    constexpr SymmetricInertia& operator=(const SymmetricInertia& other) {
        return detail::replace(*this, other);
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
/// three numbers whose product is one. They are computed here, once, so a body of a milligram is as
/// accurate as one of a ton, in `float` too. The members are read-only; another inertia may be
/// assigned as a whole.
template <class Real>
struct PrincipalInertia {
    static_assert(!std::is_integral_v<Real>,
                  "timestep: parameters are real numbers: write 1.0 instead of 1");
    using Scalar = Real;                      ///< the real number type
    static constexpr bool gyroscopic = true;  ///< whether the body has a gyroscopic torque
    const Vector3<Real> moments;              ///< I₁, I₂, I₃, kg m²
    const Vector3<Real> unit;  ///< U₁, U₂, U₃ = I₁, I₂, I₃ over ∛(I₁I₂I₃)
    const Vector3<Real> ratio;  ///< a₁ = (I₃ − I₂)/I₁ and so on round: ω̇₁ = −a₁ ω₂ ω₃

    /// Whether the constructor takes these moments.
    [[nodiscard]] static bool valid(Real I1, Real I2, Real I3) noexcept {
        return !detail::principal_fault(I1, I2, I3).rule;
    }

    /// Moments in kg m², above zero, none larger than the sum of the others; the ratio of any two,
    /// and their geometric mean, must be numbers that `Real` can hold with all digits.
    /// Throws `std::invalid_argument`.
    PrincipalInertia(Real I1, Real I2, Real I3)
        : moments(I1, I2, I3),
          unit(detail::over_their_mean(moments)),
          ratio((I3 - I2) / I1, (I1 - I3) / I2, (I2 - I1) / I3) {
        for_each_number(
            [](auto a, auto b, auto c) {
                const detail::InertiaFault fault = detail::principal_fault(a, b, c);
                if (fault.rule) detail::refuse_fault(fault);
            },
            I1, I2, I3);
    }

    PrincipalInertia(const PrincipalInertia&) = default;  ///< copies
    /// Replaces this inertia.
    PrincipalInertia& operator=(const PrincipalInertia& other) {
        return detail::replace(*this, other);
    }

    /// A body that moves alike when it is free, its moments scaled to the product one: its energy
    /// overflows for no mass.
    [[nodiscard]] PrincipalInertia scaled_to_one() const { return {unit, unit, ratio}; }

    /// Angular momentum Iω, kg m²/s.
    Vector3<Real> momentum(const Vector3<Real>& omega) const { return moments.cwiseProduct(omega); }
    /// The angular velocity of the angular momentum L, I⁻¹L, rad/s.
    Vector3<Real> velocity(const Vector3<Real>& L) const { return L.cwiseQuotient(moments); }

private:
    PrincipalInertia(const Vector3<Real>& moments_, const Vector3<Real>& unit_,
                     const Vector3<Real>& ratio_)
        : moments(moments_), unit(unit_), ratio(ratio_) {}
};

/// A symmetric matrix: the inertia in any axes, such as the modeller's. It knows its principal
/// axes. A game rotates the body's frame into them once, when it loads the body, and uses
/// PrincipalInertia from then on; the full matrix costs more in every step. The members are
/// read-only; another inertia may be assigned as a whole.
template <class Real>
struct FullInertia {
    using Scalar = Real;                      ///< the real number type
    static constexpr bool gyroscopic = true;  ///< whether the body has a gyroscopic torque
    const Matrix3<Real> matrix;               ///< kg m²
    const Matrix3<Real> unit;     ///< the matrix over a power of two, its largest number 1 to 2
    const Matrix3<Real> inverse;  ///< its inverse, 1/(kg m²)
    const Matrix3<Real> axes;     ///< the principal axes, in its columns
    const PrincipalInertia<Real> principal;  ///< the moments about those axes

    /// Whether the constructor takes this matrix.
    [[nodiscard]] static bool valid(const Matrix3<Real>& I) noexcept {
        return !Analysis(I).fault.rule;
    }

    /// A symmetric matrix in kg m² whose eigenvalues are moments that PrincipalInertia takes, none
    /// below 100 ε of the largest: in `float` a needle's least moment must be 1e-5 of its others or
    /// more. Its inverse must be finite. Throws `std::invalid_argument`.
    explicit FullInertia(const Matrix3<Real>& I) : FullInertia(I, Analysis(I)) {}

    FullInertia(const FullInertia&) = default;  ///< copies
    /// Replaces this inertia.
    FullInertia& operator=(const FullInertia& other) { return detail::replace(*this, other); }

    /// Angular momentum Iω, kg m²/s.
    Vector3<Real> momentum(const Vector3<Real>& omega) const { return times(matrix, omega); }
    /// The angular velocity of the angular momentum L, I⁻¹L, rad/s.
    Vector3<Real> velocity(const Vector3<Real>& L) const { return times(inverse, L); }

private:
    /// \cond
    // The matrix from its principal axes, and the first rule that it breaks.
    struct Analysis {
        Matrix3<Real> axes = Matrix3<Real>::Identity(), inverse = axes;
        Vector3<Real> moments = Vector3<Real>::Zero();
        detail::InertiaFault fault;

        explicit Analysis(const Matrix3<Real>& I) noexcept {
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    if (!is_finite(I(i, j))) {
                        fault = {"inertia", double(I(i, j)), "a finite number"};
                        return;
                    }
            const Real epsilon = std::numeric_limits<Real>::epsilon();
            const Real asymmetry = (I - I.transpose()).cwiseAbs().maxCoeff();
            if (asymmetry > 8 * epsilon * I.cwiseAbs().maxCoeff()) {
                fault = {"inertia's asymmetry", double(asymmetry),
                         "zero: the matrix equals its transpose"};
                return;
            }
            Matrix3<Real> diagonal = I;
            axes = eigenvectors(diagonal);
            if (axes.determinant() < 0) axes.col(0) = -axes.col(0);  // a rotation, no reflection
            moments = diagonal.diagonal();
            // Each eigenvalue, rising, is off by as much as the matrix at worst (Weyl), and that is
            // some ε of the LARGEST: up to 4 ε by the products that rotated the body into these
            // axes, and up to 3 ε by the solver (measured on a million bodies). A least moment of
            // 100 ε is known to a sixth. A smaller one has no right digit, and the body would
            // wobble by chance.
            if (std::abs(moments.x()) < 100 * (epsilon * moments.z())) {
                fault = {"least moment of inertia", double(moments.x()),
                         "100 roundoffs of the largest or more, or no digit of it is right: give "
                         "PrincipalInertia its moments, or use double"};
                return;
            }
            // A plate has I₃ = I₁ + I₂. Its apparent excess, 2I₃ minus the trace, is at most twice
            // that error; 32 ε are taken off, in case there are worse bodies.
            const Real others = moments.x() + moments.y();
            if (moments.z() <= others + 32 * (epsilon * moments.z()))
                moments.z() = std::min(moments.z(), others);
            fault = detail::principal_fault(moments.x(), moments.y(), moments.z());
            if (fault.rule) return;
            inverse = times(Matrix3<Real>(axes * moments.cwiseInverse().asDiagonal()),
                            Matrix3<Real>(axes.transpose()));
            if (!is_finite(inverse))
                fault = {"least moment of inertia", double(moments.minCoeff()),
                         "so large that the inverse of the matrix is finite"};
        }
    };
    /// \endcond

    FullInertia(const Matrix3<Real>& I, const Analysis& found)
        : matrix(I),
          unit(I / std::exp2(Real(std::ilogb(I.cwiseAbs().maxCoeff())))),
          inverse(found.inverse),
          axes(found.axes),
          principal(principal_of(found)) {}
    static PrincipalInertia<Real> principal_of(const Analysis& found) {
        if (found.fault.rule) detail::refuse_fault(found.fault);
        return {found.moments.x(), found.moments.y(), found.moments.z()};
    }
};

/// The kinetic energy ½ ω·Iω, J; `omega` in body coordinates, rad/s.
template <class Inertia>
typename Inertia::Scalar kinetic_energy(const Inertia& inertia,
                                        const Vector3<typename Inertia::Scalar>& omega) {
    return dot(omega, inertia.momentum(omega)) / 2;
}

}  // namespace timestep
