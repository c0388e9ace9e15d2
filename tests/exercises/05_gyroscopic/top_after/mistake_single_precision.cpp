#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const float angle = static_cast<float>((along - across) / across * omega.z() * t);
    const float c = std::cos(angle), s = std::sin(angle);
    return {c * omega.x() - s * omega.y(), s * omega.x() + c * omega.y(), omega.z()};
}
