#include "exercise_eigen.hpp"

// In the principal axes, where the torque has one product in each row.
Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> body(inertia);
    const Vector3d I = body.eigenvalues();
    const Matrix3d axes = body.eigenvectors();
    const Vector3d old = axes.transpose() * omega1, w = axes.transpose() * guess;
    // Eigenvectors need not be right-handed: then the cross product has the other sign.
    const double hand = h * axes.determinant();
    const double a = hand * (I[2] - I[1]), b = hand * (I[0] - I[2]), c = hand * (I[1] - I[0]);
    const Matrix3d jacobian{
        {I[0], a * w[2], a * w[1]}, {b * w[2], I[1], b * w[0]}, {c * w[1], c * w[0], I[2]}};
    const Vector3d residual(I[0] * (w[0] - old[0]) + a * w[1] * w[2],
                            I[1] * (w[1] - old[1]) + b * w[2] * w[0],
                            I[2] * (w[2] - old[2]) + c * w[0] * w[1]);
    return axes * (w - jacobian.colPivHouseholderQr().solve(residual));
}
