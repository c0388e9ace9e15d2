#include "exercise_eigen.hpp"

namespace by_vectors {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    // Stretch and velocity as vectors along the leash.
    const double stretch = x.norm() - length;
    if (!(stretch > 0)) return Vector3d::Zero();
    const Vector3d u = x.normalized();
    const Vector3d along = u * u.transpose() * v;
    const Vector3d force = -k * stretch * u - c * along;
    if (force.dot(x) > 0) return Vector3d::Zero();
    return force;
}

}  // namespace by_vectors

namespace without_direction {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    // The rate is x·v/|x|, and the force a multiple of x.
    const double square = x.squaredNorm();
    if (square <= length * length) return Vector3d::Zero();
    const double distance = std::sqrt(square);
    const double tension = k * (distance - length) + c * x.dot(v) / distance;
    if (tension < 0) return Vector3d::Zero();
    return -tension / distance * x;
}

}  // namespace without_direction
