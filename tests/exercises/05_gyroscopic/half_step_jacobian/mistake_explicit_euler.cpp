#include "exercise_eigen.hpp"

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Vector3d torque = -omega.cross(inertia.cwiseProduct(omega));
    return omega + h * torque.cwiseQuotient(inertia);
}
