#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t;
    const Quaterniond q(std::cos(angle), 0, 0, std::sin(angle));
    return q * omega;
}
