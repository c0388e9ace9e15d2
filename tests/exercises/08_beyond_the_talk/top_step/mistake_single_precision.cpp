#include "exercise_eigen.hpp"

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Eigen::Vector3f l = L.cast<float>(), u = up.cast<float>();
    const auto kick = [&](double s) { l += float(s * mgl) * u.cross(Eigen::Vector3f::UnitZ()); };
    const auto spin = [&](int i, double s) {
        const Eigen::AngleAxisf back(float(-s * l[i] / inertia[i]), Eigen::Vector3f::Unit(i));
        l = back * l;
        u = back * u;
    };
    kick(h / 2);
    spin(0, h / 2);
    spin(1, h / 2);
    spin(2, h);
    spin(1, h / 2);
    spin(0, h / 2);
    kick(h / 2);
    return {l.cast<double>(), u.cast<double>()};
}
