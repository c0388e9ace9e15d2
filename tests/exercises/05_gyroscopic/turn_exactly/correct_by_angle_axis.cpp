#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega == Vector3d::Zero()) return q;
    const double speed = omega.norm();
    return q * Eigen::AngleAxisd(speed * h, omega / speed);
}
