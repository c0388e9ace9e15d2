#include "exercise_eigen.hpp"

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
