#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    // Where the three axes of the body point. What comes out may have the other sign.
    const double angle = std::remainder(h * omega.norm(), 2 * std::numbers::pi);
    const Eigen::AngleAxisd turn(angle, omega.normalized());
    const Matrix3d R = q.toRotationMatrix() * turn.toRotationMatrix();
    return Quaterniond(R).normalized();
}
