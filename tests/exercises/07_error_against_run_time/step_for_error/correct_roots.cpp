#include "exercise.hpp"

double step_for_error(double error, double h, int order, double wanted) {
    const double ratio = wanted / error;
    if (order == 1) return h * ratio;
    if (order == 2) return h * std::sqrt(ratio);
    if (order == 3) return h * std::cbrt(ratio);
    return h * std::sqrt(std::sqrt(ratio));
}
