#include "exercise_eigen.hpp"

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    // All in the world, with the inertia tensor of this attitude.
    const Matrix3d R = q.toRotationMatrix();
    const Matrix3d I = R * inertia.asDiagonal() * R.transpose();
    const Vector3d total = torque - omega.cross(I * omega);
    return I.inverse() * total;
}
