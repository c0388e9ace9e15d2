#include "exercise_eigen.hpp"

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    if (L.norm() == 0) return {L, up};
    const auto kick = [&](double s) { L += s * mgl * up.cross(Vector3d::UnitZ()); };
    const auto spin = [&](int i, double s) {
        const Eigen::AngleAxisd back(-s * L[i] / inertia[i], Vector3d::Unit(i));
        L = back * L;
        up = back * up;
    };
    kick(h / 2);
    spin(0, h / 2);
    spin(1, h / 2);
    spin(2, h);
    spin(1, h / 2);
    spin(0, h / 2);
    kick(h / 2);
    return {L, up};
}
