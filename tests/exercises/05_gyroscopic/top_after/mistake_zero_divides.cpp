#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t;
    const double size = std::hypot(omega.x(), omega.y());
    const double c = omega.x() / size, s = omega.y() / size;  // the direction at the start
    return {size * (c * std::cos(angle) - s * std::sin(angle)),
            size * (s * std::cos(angle) + c * std::sin(angle)), omega.z()};
}
