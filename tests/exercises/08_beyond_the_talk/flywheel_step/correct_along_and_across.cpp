#include "exercise_eigen.hpp"

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    // Along k nothing changes. Across k, the part turns by atan |k| and shrinks with its cosine.
    const Vector3d root = inertia.cwiseSqrt(), y = root.cwiseProduct(omega);
    const Vector3d k = h * (inertia.cwiseProduct(omega) + wheel).cwiseProduct(root) / root.prod();
    const double size = k.norm(), cosine = 1 / std::hypot(1, size), sine = size * cosine;
    const Vector3d axis = k.normalized();
    const Vector3d along = axis.dot(y) * axis, across = y - along;
    const Vector3d y2 = along + cosine * (cosine * across + sine * axis.cross(across));
    return y2.cwiseQuotient(root);
}
