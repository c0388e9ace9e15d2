#include "exercise_eigen.hpp"

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d L = inertia.cwiseProduct(omega) + wheel;
    const Matrix3d skew{{0, -L.z(), L.y()}, {L.z(), 0, -L.x()}, {-L.y(), L.x(), 0}};
    const Matrix3d I = inertia.asDiagonal();
    return solve_linear(I - h * skew, inertia.cwiseProduct(omega));
}
