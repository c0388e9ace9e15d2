#include "exercise_eigen.hpp"

namespace about_world_axis {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    // The axis in the world, where a turn stands on the left.
    const Vector3d axis = q * omega.normalized();
    return Quaterniond(Eigen::AngleAxisd(h * omega.norm(), axis)) * q;
}

}  // namespace about_world_axis

namespace by_angle_axis {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega == Vector3d::Zero()) return q;
    const double speed = omega.norm();
    return q * Eigen::AngleAxisd(speed * h, omega / speed);
}

}  // namespace by_angle_axis

namespace by_matrix {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    // Where the three axes of the body point. What comes out may have the other sign.
    const double angle = std::remainder(h * omega.norm(), 2 * std::numbers::pi);
    const Eigen::AngleAxisd turn(angle, omega.normalized());
    const Matrix3d R = q.toRotationMatrix() * turn.toRotationMatrix();
    return Quaterniond(R).normalized();
}

}  // namespace by_matrix

namespace by_sinc {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    // sin(s)/s has no need of an axis; near zero by its series.
    const Vector3d half = h / 2 * omega;
    const double s = half.norm();
    const double sinc = s < 1e-3 ? 1 - s * s / 6 * (1 - s * s / 20) : std::sin(s) / s;
    Quaterniond turn;
    turn.w() = std::cos(s);
    turn.vec() = sinc * half;
    return q * turn;
}

}  // namespace by_sinc
