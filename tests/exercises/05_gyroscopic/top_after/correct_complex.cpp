#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    // The part across as one complex number w, whose equation is w' = i rate w.
    const double rate = (along / across - 1) * omega.z();
    const auto w = std::complex<double>(omega.x(), omega.y()) * std::polar(1.0, rate * t);
    return {w.real(), w.imag(), omega.z()};
}
