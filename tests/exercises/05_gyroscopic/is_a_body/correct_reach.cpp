#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    // How far the mass reaches along each axis, twice the sum of m x² and so on, with a tolerance.
    const double tolerance = 1e-10 * inertia.cwiseAbs().maxCoeff();
    for (int i = 0; i < 3; ++i) {
        const double reach = inertia[(i + 1) % 3] + inertia[(i + 2) % 3] - inertia[i];
        if (!(inertia[i] > 0) || reach < -tolerance) return false;
    }
    return true;
}
