#include "exercise_eigen.hpp"

namespace reach {

bool is_a_body(const Vector3d& inertia) {
    // How far the mass reaches along each axis, twice the sum of m x² and so on, with a tolerance.
    const double tolerance = 1e-10 * inertia.cwiseAbs().maxCoeff();
    for (int i = 0; i < 3; ++i) {
        const double reach = inertia[(i + 1) % 3] + inertia[(i + 2) % 3] - inertia[i];
        if (!(inertia[i] > 0) || reach < -tolerance) return false;
    }
    return true;
}

}  // namespace reach

namespace sorted {

bool is_a_body(const Vector3d& inertia) {
    // Only the largest can be too large, and only the least can be too small.
    std::array<double, 3> moments{inertia[0], inertia[1], inertia[2]};
    std::sort(moments.begin(), moments.end());
    const auto [least, middle, largest] = moments;
    return least > 0 && largest - middle <= least;
}

}  // namespace sorted

namespace triangle {

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z();
    const bool positive = a > 0 && b > 0 && c > 0;
    return positive && a <= b + c && b <= c + a && c <= a + b;
}

}  // namespace triangle
