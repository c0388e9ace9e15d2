#include "exercise_eigen.hpp"

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    using Eigen::Matrix3f, Eigen::Vector3f;
    const auto skew = [](const Vector3f& a) {
        return Matrix3f{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}};
    };
    const Matrix3f I = inertia.cast<float>();
    const Vector3f w1 = omega1.cast<float>(), w = guess.cast<float>(), L = I * w;
    const float step = static_cast<float>(h);
    const Vector3f residual = I * (w - w1) + step * w.cross(L);
    const Matrix3f jacobian = I + step * (skew(w) * I - skew(L));
    return Vector3f(w - jacobian.partialPivLu().solve(residual)).cast<double>();
}
