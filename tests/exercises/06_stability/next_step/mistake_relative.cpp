#include "exercise.hpp"

double next_step(double whole, double halves, double h, double tolerance, int order) {
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1) / std::fabs(halves);
    if (!std::isfinite(error)) return h / 5;
    if (error == 0) return 5 * h;
    const double factor = 0.9 * std::pow(tolerance / error, 1.0 / (order + 1));
    return h * std::clamp(factor, 0.2, 5.0);
}
