#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const Vector3d momentum(across * omega.x(), across * omega.y(), along * omega.z());
    return Eigen::AngleAxisd(momentum.norm() / across * t, momentum.normalized()) * omega;
}
