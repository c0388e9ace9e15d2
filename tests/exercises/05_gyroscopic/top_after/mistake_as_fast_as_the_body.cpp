#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    return Eigen::AngleAxisd(omega.z() * t, Vector3d::UnitZ()) * omega;
}
