#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double angle = h * omega.norm() * 180 / std::numbers::pi;
    return q * Eigen::AngleAxisd(angle, omega.normalized());
}
