#include "exercise_eigen.hpp"

Quaterniond last_attitude(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d mean = spins[i - 1];
        const Vector3d half = (times[i] - times[i - 1]) / 2 * mean;
        now = (now * Quaterniond(1, half.x(), half.y(), half.z())).normalized();
    }
    return now;
}
