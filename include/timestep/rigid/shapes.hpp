#pragma once
/// \file
/// The inertia of solid shapes of even density, from mass and size.

#include <timestep/rigid/inertia.hpp>

namespace timestep {

/// A ball: ⅖ m r². `mass` in kg and `radius` in m above zero; throws `std::invalid_argument`, as
/// all shapes do.
template <class Real>
UniformInertia<Real> sphere(Real mass, Real radius) {
    return UniformInertia(2 * positive("mass", mass) * positive("radius", radius) * radius / 5);
}

/// A cube: m a²/6 about every axis, although it is no ball (N41).
template <class Real>
UniformInertia<Real> cube(Real mass, Real side) {
    return UniformInertia(positive("mass", mass) * positive("side", side) * side / 6);
}

/// A box with sides `a`, `b`, `c` along x, y and z: m (b² + c²)/12 and so on round.
template <class Real>
PrincipalInertia<Real> box(Real mass, Real a, Real b, Real c) {
    positive("mass", mass);
    for (const Real side : {a, b, c}) positive("side", side);
    const Real share = mass / 12;
    return {share * (b * b + c * c), share * (c * c + a * a), share * (a * a + b * b)};
}

/// The same box by its half extents, as most engines keep them: from its centre to its faces along x, y and z.
template <class Real>
PrincipalInertia<Real> box_of_half_extents(Real mass, Real hx, Real hy, Real hz) {
    positive("mass", mass);
    for (const Real half : {hx, hy, hz}) positive("half extent", half);
    return box(mass, 2 * hx, 2 * hy, 2 * hz);
}

/// A cylinder along z: m r²/2 about it, m (3r² + l²)/12 across.
template <class Real>
SymmetricInertia<Real> cylinder(Real mass, Real radius, Real length) {
    positive("mass", mass), positive("radius", radius), positive("length", length);
    return {mass * (3 * radius * radius + length * length) / 12, mass * radius * radius / 2};
}

/// A capsule along z: a cylinder of `length` between two half balls. Each half ball's centre of mass
/// lies ⅜ r beyond the end of the cylinder.
template <class Real>
SymmetricInertia<Real> capsule(Real mass, Real radius, Real length) {
    positive("mass", mass), positive("radius", radius), positive("length", length);
    const Real volume = length + 4 * radius / 3;  // over π r²
    const Real middle = mass * (length / volume), caps = mass * (4 * radius / 3 / volume);
    const Real r2 = radius * radius, l2 = length * length;
    return {middle * (l2 / 12 + r2 / 4) + caps * (2 * r2 / 5 + l2 / 4 + 3 * length * radius / 8),
            middle * r2 / 2 + caps * 2 * r2 / 5};
}

/// A staff: a slender box, `length` along z and `thickness` along x and y.
template <class Real>
SymmetricInertia<Real> staff(Real mass, Real length, Real thickness) {
    positive("mass", mass), positive("length", length), positive("thickness", thickness);
    const Real t2 = thickness * thickness;
    return {mass * (length * length + t2) / 12, mass * t2 / 6};
}

/// A rod without thickness along z: m l²/12 across, nothing along.
template <class Real>
RodInertia<Real> rod(Real mass, Real length) {
    return RodInertia(positive("mass", mass) * positive("length", length) * length / 12);
}

}  // namespace timestep
