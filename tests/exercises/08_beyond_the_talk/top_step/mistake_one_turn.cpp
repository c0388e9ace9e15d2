#include "exercise_eigen.hpp"

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    const auto kick = [&](double s) { L += s * mgl * up.cross(Vector3d::UnitZ()); };
    kick(h / 2);
    const Vector3d omega = L.cwiseQuotient(inertia);
    const Eigen::AngleAxisd back(-h * omega.norm(), omega.normalized());
    L = back * L;
    up = back * up;
    kick(h / 2);
    return {L, up};
}
