#include "exercise_eigen.hpp"

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d half = (distance - length) / 2 * (apart / distance);
    if (wa == 0) return {a, b - 2 * half};
    if (wb == 0) return {a + 2 * half, b};
    return {a + half, b - half};
}
