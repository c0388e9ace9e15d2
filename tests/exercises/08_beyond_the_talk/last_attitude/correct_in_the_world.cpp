#include "exercise_eigen.hpp"

Quaterniond last_attitude(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d mean = now * Vector3d((spins[i - 1] + spins[i]) / 2);
        Quaterniond half(0, mean.x(), mean.y(), mean.z());
        half.coeffs() *= (times[i] - times[i - 1]) / 2;
        now.coeffs() += (half * now).coeffs();
        now.normalize();
    }
    return now;
}
