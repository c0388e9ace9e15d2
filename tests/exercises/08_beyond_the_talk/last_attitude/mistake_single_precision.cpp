#include "exercise_eigen.hpp"

Quaterniond last_attitude(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Eigen::Quaternionf now = q.cast<float>();
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d half = (times[i] - times[i - 1]) / 4 * (spins[i - 1] + spins[i]);
        const Eigen::Vector3f v = half.cast<float>();
        now = (now * Eigen::Quaternionf(1, v.x(), v.y(), v.z())).normalized();
    }
    return now.cast<double>();
}
