#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double half = h * omega.norm() / 2;
    const Vector3d v = std::sin(half) * omega.normalized();
    return Quaterniond(v.x(), v.y(), v.z(), std::cos(half)) * q;
}
