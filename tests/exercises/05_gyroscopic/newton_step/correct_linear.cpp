#include "exercise_eigen.hpp"

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
