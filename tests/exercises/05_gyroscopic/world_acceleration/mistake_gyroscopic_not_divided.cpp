#include "exercise_eigen.hpp"

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d push = (q.conjugate() * torque).cwiseQuotient(inertia);
    return q * (push - spin.cross(inertia.cwiseProduct(spin)));
}
