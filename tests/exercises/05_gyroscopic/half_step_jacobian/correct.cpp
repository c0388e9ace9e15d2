#include "exercise_eigen.hpp"

namespace momentum {

static Matrix3d skew(const Vector3d& a) { return Matrix3d{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}}; }

// The matrix times omega is L + h omega x L, and that much is taken away: L is what stays.
Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d L = I * omega;
    return (I + h / 2 * (skew(omega) * I - skew(L))).inverse() * L;
}

}  // namespace momentum

namespace products {

// The mean makes of each product y z the half of y1 z2 + z1 y2: x2 + a (y1 z2 + z1 y2) = x1 and so
// on round. Cramer's rule.
Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const double I1 = inertia.x(), I2 = inertia.y(), I3 = inertia.z();
    const double x = omega.x(), y = omega.y(), z = omega.z();
    const double a = h / 2 * (I3 - I2) / I1, b = h / 2 * (I1 - I3) / I2, c = h / 2 * (I2 - I1) / I3;
    const Vector3d column1(1, b * z, c * y), column2(a * z, 1, c * x), column3(a * y, b * x, 1);
    const Vector3d across1 = column2.cross(column3), across2 = column3.cross(column1), across3 = column1.cross(column2);
    return Vector3d(omega.dot(across1), omega.dot(across2), omega.dot(across3)) / column1.dot(across1);
}

}  // namespace products

namespace twice_half {

static Matrix3d skew(const Vector3d& a) { return Matrix3d{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}}; }

// The talk's step to the middle of the time, and the same change once more.
Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const double half = h / 2;
    const Matrix3d jacobian = I + half * (skew(omega) * I - skew(I * omega));
    const Vector3d middle = omega - jacobian.colPivHouseholderQr().solve(half * omega.cross(I * omega));
    return 2 * middle - omega;
}

}  // namespace twice_half
