#include "exercise_eigen.hpp"

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r < length || r == 0) return Vector3d::Zero();
    return -std::max(k * (r - length) + c * v.dot(x) / r, 0.0) / r * x;
}
