#include "exercise.hpp"

namespace from_stiffness {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double weight = mass * g;
    const double k = 0.25 * weight / sag;
    return {k, zeta * std::sqrt(k * mass)};
}

}  // namespace from_stiffness

namespace whole_car {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    // One mass on one spring and one damper, shared out at the end.
    const double stiffness = mass * g / sag;
    const double damping = 2 * zeta * std::sqrt(stiffness * mass);
    return {stiffness / 4, damping / 4};
}

}  // namespace whole_car
