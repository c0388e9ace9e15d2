#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    const Vector3d sizes = inertia.cwiseAbs();
    return sizes.minCoeff() > 0 && 2 * sizes.maxCoeff() <= sizes.sum();
}
