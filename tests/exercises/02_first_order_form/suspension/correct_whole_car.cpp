#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    // One mass on one spring and one damper, shared out at the end.
    const double stiffness = mass * g / sag;
    const double damping = 2 * zeta * std::sqrt(stiffness * mass);
    return {stiffness / 4, damping / 4};
}
