#include "exercise_eigen.hpp"

static Matrix3d skew(const Vector3d& a) {
    return Matrix3d{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}};
}

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    Vector3d w = omega;
    for (int i = 0; i < 2; ++i) {
        const Matrix3d jacobian = I + h / 2 * (skew(w) * I - skew(I * w));
        w -= solve_linear(jacobian, h / 2 * w.cross(I * w));
    }
    return w;
}
