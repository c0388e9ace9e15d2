#include "exercise_eigen.hpp"

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return q * (q.conjugate() * torque).cwiseQuotient(inertia);
}
