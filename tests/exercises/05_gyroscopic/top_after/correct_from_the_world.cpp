#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    // In the world the spin turns about the angular momentum, by |L|/across a second. The body's
    // axes turn with it, and about their own z, back, as much as omega has more than L/across.
    const Vector3d momentum(across * omega.x(), across * omega.y(), along * omega.z());
    const Vector3d precession = momentum / across;
    const double own = (omega - precession).z();
    return Eigen::AngleAxisd(-own * t, Vector3d::UnitZ()) * omega;
}
