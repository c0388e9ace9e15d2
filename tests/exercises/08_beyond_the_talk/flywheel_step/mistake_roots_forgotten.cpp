#include "exercise_eigen.hpp"

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d L = inertia.cwiseProduct(omega) + wheel;
    const Vector3d k = h * L.cwiseQuotient(inertia);
    return (omega + k.cross(omega) + k.dot(omega) * k) / (1 + k.squaredNorm());
}
