#include "exercise_eigen.hpp"

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d L = inertia.cwiseProduct(omega) + wheel;
    const Vector3d w = omega + h * L.cross(omega).cwiseQuotient(inertia);
    const double before = omega.dot(inertia.cwiseProduct(omega));
    const double after = w.dot(inertia.cwiseProduct(w));
    return after == 0 ? w : Vector3d(std::sqrt(before / after) * w);
}
