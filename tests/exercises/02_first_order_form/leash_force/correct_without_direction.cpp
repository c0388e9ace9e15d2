#include "exercise_eigen.hpp"

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    // The rate is x·v/|x|, and the force a multiple of x.
    const double square = x.squaredNorm();
    if (square <= length * length) return Vector3d::Zero();
    const double distance = std::sqrt(square);
    const double tension = k * (distance - length) + c * x.dot(v) / distance;
    if (tension < 0) return Vector3d::Zero();
    return -tension / distance * x;
}
