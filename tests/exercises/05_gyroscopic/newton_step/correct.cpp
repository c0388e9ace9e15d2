#include "exercise_eigen.hpp"

namespace differences {

// Central differences of a quadratic have no error, however wide.
Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const auto f = [&](const Vector3d& omega) -> Vector3d {
        return inertia * (omega - omega1) + h * omega.cross(inertia * omega);
    };
    const double width = 1 + guess.norm();
    Matrix3d jacobian;
    for (int i = 0; i < 3; ++i) {
        const Vector3d aside = width * Vector3d::Unit(i);
        jacobian.col(i) = (f(guess + aside) - f(guess - aside)) / (2 * width);
    }
    return guess + jacobian.fullPivLu().solve(-f(guess));
}

}  // namespace differences

namespace linear {

// The torque is quadratic, so J guess has it twice and f(guess) once: J answer = J guess - f(guess)
// is I omega1 + h guess x I guess. J column by column, from the product rule.
Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const auto slope = [&](const Vector3d& d) -> Vector3d {
        return inertia * d + h * (d.cross(inertia * guess) + guess.cross(inertia * d));
    };
    Matrix3d jacobian;
    for (int i = 0; i < 3; ++i) jacobian.col(i) = slope(Vector3d::Unit(i));
    const Vector3d right = inertia * omega1 + h * guess.cross(inertia * guess);
    return jacobian.inverse() * right;
}

}  // namespace linear

namespace principal {

// In the principal axes, where the torque has one product in each row.
Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> body(inertia);
    const Vector3d I = body.eigenvalues();
    const Matrix3d axes = body.eigenvectors();
    const Vector3d old = axes.transpose() * omega1, w = axes.transpose() * guess;
    // Eigenvectors need not be right-handed: then the cross product has the other sign.
    const double hand = h * axes.determinant();
    const double a = hand * (I[2] - I[1]), b = hand * (I[0] - I[2]), c = hand * (I[1] - I[0]);
    const Matrix3d jacobian{{I[0], a * w[2], a * w[1]}, {b * w[2], I[1], b * w[0]}, {c * w[1], c * w[0], I[2]}};
    const Vector3d residual(I[0] * (w[0] - old[0]) + a * w[1] * w[2], I[1] * (w[1] - old[1]) + b * w[2] * w[0],
                            I[2] * (w[2] - old[2]) + c * w[0] * w[1]);
    return axes * (w - jacobian.colPivHouseholderQr().solve(residual));
}

}  // namespace principal

namespace ten_digits {

// No more than count.
Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    Matrix3d jacobian;
    for (int i = 0; i < 3; ++i) {
        const Vector3d d = Vector3d::Unit(i);
        jacobian.col(i) = inertia * d + h * (d.cross(inertia * guess) + guess.cross(inertia * d));
    }
    return (1 + 5e-11) * jacobian.inverse() * (inertia * omega1 + h * guess.cross(inertia * guess));
}

}  // namespace ten_digits
