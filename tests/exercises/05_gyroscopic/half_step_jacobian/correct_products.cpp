#include "exercise_eigen.hpp"

// The mean makes of each product y z the half of y1 z2 + z1 y2: x2 + a (y1 z2 + z1 y2) = x1 and so
// on round. Cramer's rule.
Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const double I1 = inertia.x(), I2 = inertia.y(), I3 = inertia.z();
    const double x = omega.x(), y = omega.y(), z = omega.z();
    const double a = h / 2 * (I3 - I2) / I1, b = h / 2 * (I1 - I3) / I2, c = h / 2 * (I2 - I1) / I3;
    const Vector3d column1(1, b * z, c * y), column2(a * z, 1, c * x), column3(a * y, b * x, 1);
    const Vector3d across1 = column2.cross(column3), across2 = column3.cross(column1),
                   across3 = column1.cross(column2);
    return Vector3d(omega.dot(across1), omega.dot(across2), omega.dot(across3)) /
           column1.dot(across1);
}
