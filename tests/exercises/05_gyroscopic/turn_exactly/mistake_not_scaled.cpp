#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const Vector3d half = h / 2 * omega;
    const Quaterniond rate = q * Quaterniond(0, half.x(), half.y(), half.z());
    return Quaterniond(q.coeffs() + rate.coeffs());
}
