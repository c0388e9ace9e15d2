#include "exercise_eigen.hpp"

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    using Vector3f = Eigen::Vector3f;
    const Vector3f I = inertia.cast<float>();
    const Eigen::Quaternionf turn = q.cast<float>();
    const Vector3f spin = turn.conjugate() * omega.cast<float>();
    const Vector3f push = turn.conjugate() * torque.cast<float>();
    const Vector3f total = push - spin.cross(I.cwiseProduct(spin));
    return (turn * total.cwiseQuotient(I)).cast<double>();
}
