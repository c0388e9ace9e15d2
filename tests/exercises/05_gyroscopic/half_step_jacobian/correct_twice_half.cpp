#include "exercise_eigen.hpp"

static Matrix3d skew(const Vector3d& a) {
    return Matrix3d{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}};
}

// The talk's step to the middle of the time, and the same change once more.
Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const double half = h / 2;
    const Matrix3d jacobian = I + half * (skew(omega) * I - skew(I * omega));
    const Vector3d middle =
        omega - jacobian.colPivHouseholderQr().solve(half * omega.cross(I * omega));
    return 2 * middle - omega;
}
