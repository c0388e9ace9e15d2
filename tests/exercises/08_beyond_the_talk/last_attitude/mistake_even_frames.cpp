#include "exercise_eigen.hpp"

Quaterniond last_attitude(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    const double gaps = double(times.size()) - 1;
    const double gap = gaps == 0 ? 0 : (times.back() - times[0]) / gaps;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d mean = (spins[i - 1] + spins[i]) / 2;
        const Vector3d half = gap / 2 * mean;
        now = (now * Quaterniond(1, half.x(), half.y(), half.z())).normalized();
    }
    return now;
}
