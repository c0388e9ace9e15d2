#include "exercise_eigen.hpp"

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d total = q.conjugate() * torque - omega.cross(inertia.cwiseProduct(omega));
    return q * total.cwiseQuotient(inertia);
}
