#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    return Quaterniond(Eigen::AngleAxisd(h * omega.norm(), omega.normalized()));
}
