#include "exercise_eigen.hpp"

namespace axis {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = t * omega.z() * (along - across) / across;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace axis

namespace complex {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    // The part across as one complex number w, whose equation is w' = i rate w.
    const double rate = (along / across - 1) * omega.z();
    const auto w = std::complex<double>(omega.x(), omega.y()) * std::polar(1.0, rate * t);
    return {w.real(), w.imag(), omega.z()};
}

}  // namespace complex

namespace from_the_world {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    // In the world the spin turns about the angular momentum, by |L|/across a second. The body's
    // axes turn with it, and about their own z, back, as much as omega has more than L/across.
    const Vector3d momentum(across * omega.x(), across * omega.y(), along * omega.z());
    const Vector3d precession = momentum / across;
    const double own = (omega - precession).z();
    return Eigen::AngleAxisd(-own * t, Vector3d::UnitZ()) * omega;
}

}  // namespace from_the_world

namespace quarter_turn {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    // Both components are cosines, of angles a quarter turn apart.
    const double angle = (along / across - 1) * omega.z() * t, start = std::atan2(omega.y(), omega.x());
    const double size = std::hypot(omega.x(), omega.y());
    return {size * std::cos(start + angle), size * std::cos(start + angle - std::numbers::pi / 2), omega.z()};
}

}  // namespace quarter_turn
