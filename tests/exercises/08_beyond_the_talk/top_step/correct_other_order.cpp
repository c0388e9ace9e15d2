#include "exercise_eigen.hpp"

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    // Any order that reads the same from both ends will do: here z, y, x, gravity, x, y, z.
    const auto spin = [&](int i) {
        const Eigen::AngleAxisd back(-h / 2 * L[i] / inertia[i], Vector3d::Unit(i));
        L = back * L;
        up = back * up;
    };
    spin(2);
    spin(1);
    spin(0);
    L += h * mgl * up.cross(Vector3d::UnitZ());
    spin(0);
    spin(1);
    spin(2);
    return {L, up};
}
