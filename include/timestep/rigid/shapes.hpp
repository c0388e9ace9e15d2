#pragma once
/// \file
/// The inertia of solid shapes of uniform density, from mass and size.

#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// \cond
namespace detail {
// The moments from sizes that have been checked: for the shapes and for their valid_ functions.
template <class Real>
struct Symmetric {
    Real across, along;
};
template <class Real>
constexpr Real sphere_moment(Real mass, Real radius) {
    return 2 * mass * radius * radius / 5;
}
template <class Real>
constexpr Real cube_moment(Real mass, Real side) {
    return mass * side * side / 6;
}
template <class Real>
constexpr Real rod_moment(Real mass, Real length) {
    return mass * length * length / 12;
}
template <class Real>
constexpr Symmetric<Real> cylinder_moments(Real mass, Real radius, Real length) {
    return {mass * (3 * radius * radius + length * length) / 12, mass * radius * radius / 2};
}
template <class Real>
constexpr Symmetric<Real> capsule_moments(Real mass, Real radius, Real length) {
    const Real volume = length + 4 * radius / 3;  // over π r²
    const Real middle = mass * (length / volume), caps = mass * (4 * radius / 3 / volume);
    const Real r2 = radius * radius, l2 = length * length;
    return {middle * (l2 / 12 + r2 / 4) + caps * (2 * r2 / 5 + l2 / 4 + 3 * length * radius / 8),
            middle * r2 / 2 + caps * 2 * r2 / 5};
}
template <class Real>
constexpr Symmetric<Real> staff_moments(Real mass, Real length, Real thickness) {
    const Real t2 = thickness * thickness;
    return {mass * (length * length + t2) / 12, mass * t2 / 6};
}
template <class Real>
constexpr bool are_positive(Real a, Real b, Real c) {
    return is_positive(a) && is_positive(b) && is_positive(c);
}
template <class Real>
constexpr bool is_body(const Symmetric<Real>& I) {
    return SymmetricInertia<Real>::valid(I.across, I.along);
}
}  // namespace detail
/// \endcond

/// A ball: ⅖ m r². `mass` in kg and `radius` in m, above zero. Throws `std::invalid_argument`, as
/// all shapes do. For each shape there is a function that reports, without an exception, whether it
/// would.
template <class Real>
constexpr UniformInertia<Real> sphere(Real mass, Real radius) {
    return UniformInertia(
        detail::sphere_moment(positive("mass", mass), positive("radius", radius)));
}
/// Whether sphere() takes these sizes.
template <class Real>
[[nodiscard]] constexpr bool valid_sphere(Real mass, Real radius) noexcept {
    return detail::are_positive(mass, radius, radius) &&
           UniformInertia<Real>::valid(detail::sphere_moment(mass, radius));
}

/// A cube: m a²/6 about every axis, although it is no ball (N41).
template <class Real>
constexpr UniformInertia<Real> cube(Real mass, Real side) {
    return UniformInertia(detail::cube_moment(positive("mass", mass), positive("side", side)));
}
/// Whether cube() takes these sizes.
template <class Real>
[[nodiscard]] constexpr bool valid_cube(Real mass, Real side) noexcept {
    return detail::are_positive(mass, side, side) &&
           UniformInertia<Real>::valid(detail::cube_moment(mass, side));
}

/// A box with sides `a`, `b`, `c` along x, y and z: m (b² + c²)/12 and so on round.
template <class Real>
PrincipalInertia<Real> box(Real mass, Real a, Real b, Real c) {
    positive("mass", mass);
    for (const Real side : {a, b, c}) positive("side", side);
    const Real share = mass / 12;
    return {share * (b * b + c * c), share * (c * c + a * a), share * (a * a + b * b)};
}
/// Whether box() takes these sizes.
template <class Real>
[[nodiscard]] bool valid_box(Real mass, Real a, Real b, Real c) noexcept {
    const Real share = mass / 12;
    return detail::is_positive(mass) && detail::are_positive(a, b, c) &&
           PrincipalInertia<Real>::valid(share * (b * b + c * c), share * (c * c + a * a),
                                         share * (a * a + b * b));
}

/// A box by its half extents, m, which most engines store: from its centre to its faces along x, y
/// and z.
template <class Real>
PrincipalInertia<Real> box_of_half_extents(Real mass, Real hx, Real hy, Real hz) {
    positive("mass", mass);
    for (const Real half : {hx, hy, hz}) positive("half extent", half);
    return box(mass, 2 * hx, 2 * hy, 2 * hz);
}

/// A cylinder along z: m r²/2 about it, m (3r² + l²)/12 across. Along another axis: about().
template <class Real>
constexpr SymmetricInertia<Real> cylinder(Real mass, Real radius, Real length) {
    positive("mass", mass), positive("radius", radius), positive("length", length);
    const detail::Symmetric<Real> I = detail::cylinder_moments(mass, radius, length);
    return {I.across, I.along};
}
/// Whether cylinder() takes these sizes.
template <class Real>
[[nodiscard]] constexpr bool valid_cylinder(Real mass, Real radius, Real length) noexcept {
    return detail::are_positive(mass, radius, length) &&
           detail::is_body(detail::cylinder_moments(mass, radius, length));
}

/// A capsule along z: a cylinder of `length` between two half balls (Bullet's height is that
/// length; Jolt's and Box3D's capsules go by half of it, or by its ends). Each half ball's centre
/// of mass lies ⅜ r beyond the end of the cylinder. Along another axis: about().
template <class Real>
constexpr SymmetricInertia<Real> capsule(Real mass, Real radius, Real length) {
    positive("mass", mass), positive("radius", radius), positive("length", length);
    const detail::Symmetric<Real> I = detail::capsule_moments(mass, radius, length);
    return {I.across, I.along};
}
/// Whether capsule() takes these sizes.
template <class Real>
[[nodiscard]] constexpr bool valid_capsule(Real mass, Real radius, Real length) noexcept {
    return detail::are_positive(mass, radius, length) &&
           detail::is_body(detail::capsule_moments(mass, radius, length));
}

/// A staff: a slender box, `length` along z and `thickness` along x and y. Along another axis:
/// about().
template <class Real>
constexpr SymmetricInertia<Real> staff(Real mass, Real length, Real thickness) {
    positive("mass", mass), positive("length", length), positive("thickness", thickness);
    const detail::Symmetric<Real> I = detail::staff_moments(mass, length, thickness);
    return {I.across, I.along};
}
/// Whether staff() takes these sizes.
template <class Real>
[[nodiscard]] constexpr bool valid_staff(Real mass, Real length, Real thickness) noexcept {
    return detail::are_positive(mass, length, thickness) &&
           detail::is_body(detail::staff_moments(mass, length, thickness));
}

/// A rod without thickness along z: m l²/12 across, nothing along.
template <class Real>
constexpr RodInertia<Real> rod(Real mass, Real length) {
    return RodInertia(detail::rod_moment(positive("mass", mass), positive("length", length)));
}
/// Whether rod() takes these sizes.
template <class Real>
[[nodiscard]] constexpr bool valid_rod(Real mass, Real length) noexcept {
    return detail::are_positive(mass, length, length) &&
           RodInertia<Real>::valid(detail::rod_moment(mass, length));
}

}  // namespace timestep
