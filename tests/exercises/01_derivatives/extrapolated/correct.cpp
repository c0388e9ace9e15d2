#include "exercise.hpp"

namespace error_constant {

// Finds C, and takes the error of the coarse result away.
double extrapolated(double coarse, double fine, double ratio, int order) {
    const double fine_step = 1, coarse_step = ratio;  // in units of the smaller step
    const double c = (coarse - fine) / (std::pow(coarse_step, order) - std::pow(fine_step, order));
    return coarse - c * std::pow(coarse_step, order);
}

}  // namespace error_constant

namespace weights {

double extrapolated(double coarse, double fine, double ratio, int order) {
    double power = 1;
    for (int i = 0; i < order; ++i) power *= ratio;
    return (power * fine - coarse) / (power - 1);
}

}  // namespace weights
