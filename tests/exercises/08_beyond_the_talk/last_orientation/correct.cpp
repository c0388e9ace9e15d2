#include "exercise_eigen.hpp"

namespace by_cayley {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d half = (times[i] - times[i - 1]) / 4 * (spins[i - 1] + spins[i]);
        now = (now * Quaterniond(1, half.x(), half.y(), half.z())).normalized();
    }
    return now;
}

}  // namespace by_cayley

namespace in_the_world {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d mean = now * Vector3d((spins[i - 1] + spins[i]) / 2);
        const Vector3d half = (times[i] - times[i - 1]) / 2 * mean;
        const Quaterniond change = Quaterniond(0, half.x(), half.y(), half.z()) * now;
        now = Quaterniond(now.coeffs() + change.coeffs()).normalized();
    }
    return now;
}

}  // namespace in_the_world

namespace two_halves {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    // Half of each gap with the spin of either end.
    const auto turn = [](const Vector3d& angle) {
        const double half = angle.norm() / 2, sinc = half < 1e-4 ? 1 : std::sin(half) / half;
        const Vector3d v = sinc / 2 * angle;
        return Quaterniond(std::cos(half), v.x(), v.y(), v.z());
    };
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double half_gap = (times[i] - times[i - 1]) / 2;
        now = (now * turn(half_gap * spins[i - 1]) * turn(half_gap * spins[i])).normalized();
    }
    return now;
}

}  // namespace two_halves
