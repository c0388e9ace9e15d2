#include "exercise_eigen.hpp"

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Eigen::Vector3f root = inertia.cwiseSqrt().cast<float>();
    const Eigen::Vector3f y = root.cwiseProduct(omega.cast<float>());
    const Eigen::Vector3f L = (inertia.cwiseProduct(omega) + wheel).cast<float>();
    const Eigen::Vector3f k = float(h) / root.prod() * root.cwiseProduct(L);
    const Eigen::Vector3f y2 = (y + k.cross(y) + k.dot(y) * k) / (1 + k.squaredNorm());
    return y2.cwiseQuotient(root).cast<double>();
}
