#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = t * omega.z() * (along - across) / across;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}
