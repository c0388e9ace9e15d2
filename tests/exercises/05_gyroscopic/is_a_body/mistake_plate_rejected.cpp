#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    return inertia.minCoeff() > 0 && 2 * inertia.maxCoeff() < inertia.sum();
}
