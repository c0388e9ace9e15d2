#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    // The axis in the world, where a turn stands on the left.
    const Vector3d axis = q * omega.normalized();
    return Quaterniond(Eigen::AngleAxisd(h * omega.norm(), axis)) * q;
}
