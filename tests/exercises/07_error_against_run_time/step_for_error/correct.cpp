#include "exercise.hpp"

namespace constant {

double step_for_error(double error, double h, int order, double wanted) {
    const double C = error / std::pow(h, order);
    return std::pow(wanted / C, 1.0 / order);
}

}  // namespace constant

namespace logarithms {

double step_for_error(double error, double h, int order, double wanted) {
    // Along the straight line of the diagram.
    const double slope = order;
    return std::exp(std::log(h) + (std::log(wanted) - std::log(error)) / slope);
}

}  // namespace logarithms

namespace roots {

double step_for_error(double error, double h, int order, double wanted) {
    const double ratio = wanted / error;
    if (order == 1) return h * ratio;
    if (order == 2) return h * std::sqrt(ratio);
    if (order == 3) return h * std::cbrt(ratio);
    return h * std::sqrt(std::sqrt(ratio));
}

}  // namespace roots
