#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    return q * Eigen::AngleAxisd(h * omega.norm() / 2, omega.normalized());
}
