#include "exercise_eigen.hpp"

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -(k * (r - length) + c * v.dot(x) / r) / r * x;
}
