#include "exercise_eigen.hpp"

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r == 0) return Vector3d::Zero();
    const Vector3d u = x / r;
    const double tension = k * (r - length) + c * v.dot(u);
    return r > length ? Vector3d(-std::max(tension, 0.0) * u) : Vector3d(-tension * u);
}
