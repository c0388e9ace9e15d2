#include "exercise_eigen.hpp"

static Matrix3d skew(const Vector3d& a) {
    return Matrix3d{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}};
}

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d begin = -omega.cross(I * omega);
    Vector3d w = omega;
    for (int i = 0; i < 10; ++i) {
        const Vector3d residual = I * (w - omega) - h / 2 * (begin - w.cross(I * w));
        const Matrix3d jacobian = I + h / 2 * (skew(w) * I - skew(I * w));
        w -= solve_linear(jacobian, residual);
    }
    return w;
}
