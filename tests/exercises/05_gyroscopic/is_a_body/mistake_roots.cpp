#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    if (inertia.minCoeff() <= 0) return false;
    const Vector3d radii = inertia.cwiseSqrt();
    return 2 * radii.maxCoeff() <= radii.sum();
}
