#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double rate = (along - across) / across * omega.z();
    return omega + t * rate * Vector3d::UnitZ().cross(omega);
}
