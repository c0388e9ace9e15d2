#include "exercise_eigen.hpp"

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d root = inertia.cwiseSqrt();
    const Vector3d y = root.cwiseProduct(omega);
    const Vector3d L = inertia.cwiseProduct(omega) + wheel;
    const Vector3d k = h / 2 / root.prod() * root.cwiseProduct(L);
    const Vector3d y2 = y + 2 / (1 + k.squaredNorm()) * (k.cross(y) + k.cross(k.cross(y)));
    return y2.cwiseQuotient(root);
}
