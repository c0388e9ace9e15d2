#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double half = h * omega.norm() / 2;
    const Vector3d v = std::sin(half) * omega.normalized();
    Quaterniond turn;
    turn.coeffs() << std::cos(half), v;
    return q * turn;
}
