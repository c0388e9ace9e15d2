#include "exercise_eigen.hpp"

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    Vector3d w = omega;
    for (int i = 0; i < 2; ++i) {
        const Vector3d root = inertia.cwiseSqrt();
        const Vector3d y = root.cwiseProduct(omega);
        const Vector3d L = inertia.cwiseProduct(w) + wheel;
        const Vector3d k = h / root.prod() * root.cwiseProduct(L);
        const Vector3d y2 = (y + k.cross(y) + k.dot(y) * k) / (1 + k.squaredNorm());
        w = y2.cwiseQuotient(root);
    }
    return w;
}
