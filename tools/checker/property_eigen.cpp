#include "property_eigen.hpp"

#include <numbers>

namespace checker {

// Archimedes: height and longitude uniform make the sphere uniform.
Eigen::Vector3d draw_direction(Draw& draw) {
    const double z = draw.real(-1, 1), longitude = draw.real(0, 2 * std::numbers::pi);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(longitude), r * std::sin(longitude), z};
}

Eigen::Quaterniond draw_rotation(Draw& draw) {
    const double angle = draw.real(0, 2 * std::numbers::pi);
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, draw_direction(draw)));
}

// I₁ = Σmy² + Σmz² and so on: any three second moments of mass that are not negative make a body.
Eigen::Vector3d draw_moments(Draw& draw, double ratio) {
    const double size = draw.log(0.01, 100);
    for (;;) {
        const double x = draw.log(1 / ratio, 1), y = draw.log(1 / ratio, 1),
                     z = draw.log(1 / ratio, 1);
        const Eigen::Vector3d moments(y + z, z + x, x + y);
        if (moments.maxCoeff() <= ratio * moments.minCoeff()) return size * moments;
    }
}

}  // namespace checker
