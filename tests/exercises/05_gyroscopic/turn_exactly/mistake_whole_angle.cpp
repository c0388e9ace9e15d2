#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double angle = h * omega.norm();
    const Vector3d v = std::sin(angle) * omega.normalized();
    return q * Quaterniond(std::cos(angle), v.x(), v.y(), v.z());
}
