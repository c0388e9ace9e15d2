#include "exercise_eigen.hpp"

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Vector3d L = inertia.cwiseProduct(omega), torque = -omega.cross(L);
    const Vector3d slope = torque.cwiseQuotient(inertia);
    const Vector3d torque_rate = -slope.cross(L) - omega.cross(torque);
    return omega + h * (torque + h / 2 * torque_rate).cwiseQuotient(inertia);
}
