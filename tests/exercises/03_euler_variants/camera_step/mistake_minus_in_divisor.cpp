#include "exercise.hpp"

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 - 2 * zeta * wh - wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}
