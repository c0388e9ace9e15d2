#include "exercise_eigen.hpp"

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const double distance = (a - b).norm();
    const double too_long = std::max(0.0, distance - length);
    if (too_long == 0) return {a, b};
    const Vector3d inwards = too_long / distance * (b - a);
    if (wa > 0) a += inwards / (1 + wb / wa);
    if (wb > 0) b -= inwards / (1 + wa / wb);
    return {a, b};
}
