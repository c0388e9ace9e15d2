#include "exercise_eigen.hpp"

Quaterniond last_attitude(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d mean = (spins[i - 1] + spins[i]) / 2;
        const double speed = mean.norm();
        now = now * Eigen::AngleAxisd(speed * (times[i] - times[i - 1]), mean / speed);
    }
    return now;
}
