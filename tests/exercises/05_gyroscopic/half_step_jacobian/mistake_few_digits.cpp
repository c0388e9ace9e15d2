#include "exercise_eigen.hpp"

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    using Eigen::Vector3f;
    const Vector3f I = inertia.cast<float>(), w = omega.cast<float>();
    const float half = static_cast<float>(h / 2);
    const Vector3f e =
        half * Vector3f((I[2] - I[1]) / I[0], (I[0] - I[2]) / I[1], (I[1] - I[0]) / I[2]);
    const Eigen::Matrix3f matrix{{1, e[0] * w[2], e[0] * w[1]},
                                 {e[1] * w[2], 1, e[1] * w[0]},
                                 {e[2] * w[1], e[2] * w[0], 1}};
    return Vector3f(matrix.partialPivLu().solve(w)).cast<double>();
}
