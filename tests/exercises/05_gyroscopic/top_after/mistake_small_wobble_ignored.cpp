#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    if (std::hypot(omega.x(), omega.y()) < 1e-6) return omega;
    const double angle = (along - across) / across * omega.z() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}
