#include "exercise_eigen.hpp"

Quaterniond last_attitude(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (times[i] == times[i - 1]) ++i;
        if (i == times.size()) break;
        const double gap = times[i] - times[i - 1];
        const Vector3d slope = (spins[i] - spins[i - 1]) / gap;
        const Vector3d half = gap / 2 * (spins[i - 1] + gap / 2 * slope);
        now = (now * Quaterniond(1, half.x(), half.y(), half.z())).normalized();
    }
    return now;
}
