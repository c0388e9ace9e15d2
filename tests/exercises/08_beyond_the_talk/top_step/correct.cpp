#include "exercise_eigen.hpp"

namespace by_components {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    // A turn about axis i mixes the two components that follow it, going round.
    const auto turn = [](Vector3d& v, int i, double c, double s) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double before = v[j];
        v[j] = c * before + s * v[k];
        v[k] = c * v[k] - s * before;
    };
    const std::array<double, 5> times{h / 2, h / 2, h, h / 2, h / 2};
    const std::array<int, 5> axes{0, 1, 2, 1, 0};
    L += Vector3d(up.y(), -up.x(), 0) * (mgl * h / 2);
    for (std::size_t part = 0; part < 5; ++part) {
        const int i = axes[part];
        const double angle = times[part] * L[i] / inertia[i];
        turn(L, i, std::cos(angle), std::sin(angle));
        turn(up, i, std::cos(angle), std::sin(angle));
    }
    L += Vector3d(up.y(), -up.x(), 0) * (mgl * h / 2);
    return {L, up};
}

}  // namespace by_components

namespace by_quaternion {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    // The whole turn of the step as a quaternion: it takes vectors of the old axes to the new.
    const Vector3d down(0, 0, -mgl * h / 2);
    L += down.cross(up);
    Quaterniond turn = Quaterniond::Identity();
    const double half = h / 2;
    for (const auto& [i, time] : {std::pair{0, half}, {1, half}, {2, h}, {1, half}, {0, half}}) {
        const double momentum = (turn * L)[i];
        turn = Eigen::AngleAxisd(-momentum * time / inertia[i], Vector3d::Unit(i)) * turn;
    }
    up = (turn * up).normalized();
    return {turn * L + down.cross(up), up};
}

}  // namespace by_quaternion
