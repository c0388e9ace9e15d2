#include "exercise_eigen.hpp"

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d L = inertia.cwiseProduct(omega) + wheel;
    return omega + h * L.cross(omega).cwiseQuotient(inertia);
}
