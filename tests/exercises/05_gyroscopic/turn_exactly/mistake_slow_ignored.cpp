#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() < 1e-9) return q;
    return q * Eigen::AngleAxisd(h * omega.norm(), omega.normalized());
}
