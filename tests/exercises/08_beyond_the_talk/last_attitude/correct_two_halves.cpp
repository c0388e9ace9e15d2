#include "exercise_eigen.hpp"

Quaterniond last_attitude(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    // Half of each gap with the spin of either end.
    const auto turn = [](const Vector3d& angle) {
        const double half = angle.norm() / 2, sinc = half < 1e-4 ? 1 : std::sin(half) / half;
        const Vector3d v = sinc / 2 * angle;
        return Quaterniond(std::cos(half), v.x(), v.y(), v.z());
    };
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double half_gap = (times[i] - times[i - 1]) / 2;
        now = now * turn(half_gap * spins[i - 1]) * turn(half_gap * spins[i]);
        now.normalize();
    }
    return now;
}
