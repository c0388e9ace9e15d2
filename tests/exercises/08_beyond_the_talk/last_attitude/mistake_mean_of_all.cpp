#include "exercise_eigen.hpp"

Quaterniond last_attitude(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& spin : spins) mean += spin / double(spins.size());
    const Vector3d turn = (times.back() - times[0]) * mean;
    return (q * Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized()))).normalized();
}
