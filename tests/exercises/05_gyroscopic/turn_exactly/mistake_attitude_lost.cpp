#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() == 0) return Quaterniond::Identity();
    return q * Eigen::AngleAxisd(h * omega.norm(), omega.normalized());
}
