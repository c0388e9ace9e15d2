#include "exercise_eigen.hpp"

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = torque - spin.cross(inertia.cwiseProduct(spin));
    return q * total.cwiseQuotient(inertia);
}
