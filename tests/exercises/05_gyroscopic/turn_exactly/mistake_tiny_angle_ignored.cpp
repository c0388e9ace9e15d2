#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double angle = h * omega.norm();
    if (std::fabs(angle) < 1e-6) return q;
    return q * Eigen::AngleAxisd(angle, omega.normalized());
}
