#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    // Only the largest can be too large, and only the least can be too small.
    std::array<double, 3> moments{inertia[0], inertia[1], inertia[2]};
    std::sort(moments.begin(), moments.end());
    const auto [least, middle, largest] = moments;
    return least > 0 && largest - middle <= least;
}
