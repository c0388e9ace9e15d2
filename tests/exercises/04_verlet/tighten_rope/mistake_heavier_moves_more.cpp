#include "exercise_eigen.hpp"

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * (apart / distance);
    return {a + wb * pull, b - wa * pull};
}
