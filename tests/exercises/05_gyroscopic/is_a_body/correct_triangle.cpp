#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z();
    const bool positive = a > 0 && b > 0 && c > 0;
    return positive && a <= b + c && b <= c + a && c <= a + b;
}
