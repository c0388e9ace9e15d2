#include "exercise_eigen.hpp"

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    a += wa / (wa + wb) * (distance - length) * (apart / distance);
    const Vector3d rest = b - a;
    b -= wb / (wa + wb) * (rest.norm() - length) * rest.normalized();
    return {a, b};
}
