#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t * std::numbers::pi / 180;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}
