#include "exercise_eigen.hpp"

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
