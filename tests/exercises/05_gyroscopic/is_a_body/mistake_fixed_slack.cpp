#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z(), slack = 1e-9;
    const bool positive = a > 0 && b > 0 && c > 0;
    return positive && a <= b + c + slack && b <= c + a + slack && c <= a + b + slack;
}
