#include "exercise_eigen.hpp"

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
