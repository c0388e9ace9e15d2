#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const Eigen::AngleAxisd turn(h * omega.norm(), omega.normalized());
    return Quaterniond(turn) * q;
}
