#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    // sin(s)/s has no need of an axis; near zero by its series.
    const Vector3d half = h / 2 * omega;
    const double s = half.norm();
    const double sinc = s < 1e-3 ? 1 - s * s / 6 * (1 - s * s / 20) : std::sin(s) / s;
    Quaterniond turn;
    turn.w() = std::cos(s);
    turn.vec() = sinc * half;
    return q * turn;
}
