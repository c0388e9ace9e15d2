#pragma once
/// \file
/// Properties of vectors, matrices and rotations.

#include <Eigen/Geometry>

#include "numbers_eigen.hpp"
#include "property.hpp"

namespace checker {

/// Components uniform in [low, high).
inline Eigen::Vector3d draw_vector(Draw& draw, double low, double high) {
    const double x = draw.real(low, high), y = draw.real(low, high), z = draw.real(low, high);
    return {x, y, z};
}

/// A unit vector.
Eigen::Vector3d draw_direction(Draw& draw);

/// A rotation, about any axis by any angle.
Eigen::Quaterniond draw_rotation(Draw& draw);

/// Principal moments of inertia that a body can have (none exceeds the sum of the others), the
/// largest at most `ratio` times the least, kg m².
Eigen::Vector3d draw_moments(Draw& draw, double ratio);

/// The same of a body of which the first axis is a rod's: of moments with the least `least`, kg m², the other two are
/// up to `ratio` times as large, and differ by less than the first.
Eigen::Vector3d draw_rod(Draw& draw, double least, double ratio);

/// Can a body have these as its moments?
bool is_of_a_body(const Eigen::Vector3d& inertia);

/// Do two vectors, matrices or the like agree to `relative` of the larger, or to `absolute`?
template <class A, class B>
bool close(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b, double relative, double absolute = 0) {
    return close((a - b).norm(), 0, 0, std::max(allowed_share(relative) * std::max(a.norm(), b.norm()), absolute));
}

}  // namespace checker

using checker::close, checker::draw_direction, checker::draw_moments, checker::draw_rod, checker::draw_rotation,
    checker::draw_vector, checker::is_of_a_body;
