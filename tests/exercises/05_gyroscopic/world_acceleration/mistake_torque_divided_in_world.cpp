#include "exercise_eigen.hpp"

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d gyroscopic = -spin.cross(inertia.cwiseProduct(spin));
    return torque.cwiseQuotient(inertia) + q * gyroscopic.cwiseQuotient(inertia);
}
