#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    return inertia.minCoeff() > 0 && inertia.maxCoeff() <= 2 * inertia.minCoeff();
}
