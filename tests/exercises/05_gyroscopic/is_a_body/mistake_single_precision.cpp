#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    const Eigen::Vector3f moments = inertia.cast<float>();
    return moments.minCoeff() > 0 && 2 * moments.maxCoeff() <= moments.sum();
}
