// turn_exactly wrong: The body turns half as far as it should
#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double speed = omega.norm();
    return q * Eigen::AngleAxisd(speed * h / 2, omega / speed);
}
