#include "exercise_eigen.hpp"

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const auto slope = [&](const Vector3d& w) -> Vector3d {
        return -w.cross(inertia.cwiseProduct(w)).cwiseQuotient(inertia);
    };
    const Vector3d begin = slope(omega), end = slope(omega + h * begin);
    return omega + h / 2 * (begin + end);
}
