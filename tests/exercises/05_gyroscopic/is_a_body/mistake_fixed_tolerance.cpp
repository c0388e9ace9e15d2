#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    const double tolerance = 1e-6;
    return inertia.minCoeff() > tolerance && 2 * inertia.maxCoeff() <= inertia.sum() + tolerance;
}
