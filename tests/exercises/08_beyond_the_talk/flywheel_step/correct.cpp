#include "exercise_eigen.hpp"

namespace along_and_across {

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

}  // namespace along_and_across

namespace in_omega {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    // Without roots: the equation is (1 - S) w2 = w1 with S = h I^-1 [L1], whose cube is -s S.
    const Vector3d V = inertia.cwiseInverse();
    const Vector3d l = h * (inertia.cwiseProduct(omega) + wheel);
    const Vector3d S_w = V.cwiseProduct(l.cross(omega));
    const double s = l.cwiseProduct(l).dot(inertia) * V.prod();
    const Vector3d rest = V.prod() * inertia.cwiseProduct(omega).dot(l) * l;
    return (omega + S_w + rest) / (1 + s);
}

}  // namespace in_omega
