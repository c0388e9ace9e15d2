#include "exercise_eigen.hpp"

namespace by_components {

// Euler's equations, one axis of the body after the other.
Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    Vector3d acceleration = Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const Vector3d x = q * Vector3d::Unit(i);
        const Vector3d y = q * Vector3d::Unit(j), z = q * Vector3d::Unit(k);
        const double gyroscopic = (inertia[j] - inertia[k]) * omega.dot(y) * omega.dot(z);
        acceleration += (torque.dot(x) + gyroscopic) / inertia[i] * x;
    }
    return acceleration;
}

}  // namespace by_components

namespace by_tensor {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    // All in the world, with the inertia tensor of this orientation.
    const Matrix3d R = q.toRotationMatrix();
    const Matrix3d I = R * inertia.asDiagonal() * R.transpose();
    const Vector3d total = torque - omega.cross(I * omega);
    return I.inverse() * total;
}

}  // namespace by_tensor
