#include "exercise_eigen.hpp"

Quaterniond last_attitude(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond turn = Quaterniond::Identity();
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        const Vector3d angle = (times[i + 1] - times[i]) * (0.5 * spins[i] + 0.5 * spins[i + 1]);
        turn = turn * Eigen::AngleAxisd(angle.norm(), angle.normalized());
    }
    return (q * turn).normalized();
}
