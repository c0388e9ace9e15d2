#include "exercise_eigen.hpp"

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(inertia * guess);
    return guess - inertia.inverse() * residual;
}
