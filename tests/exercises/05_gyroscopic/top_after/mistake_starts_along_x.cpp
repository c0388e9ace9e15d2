#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t;
    const double size = std::hypot(omega.x(), omega.y());
    return {size * std::cos(angle), size * std::sin(angle), omega.z()};
}
