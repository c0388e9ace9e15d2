#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    const Vector3d squares = inertia.cwiseAbs2();
    return inertia.minCoeff() > 0 && 2 * squares.maxCoeff() <= squares.sum();
}
