#include "exercise_eigen.hpp"

static Matrix3d skew(const Vector3d& a) {
    return Matrix3d{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}};
}

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return guess - solve_linear(jacobian, residual);
}
