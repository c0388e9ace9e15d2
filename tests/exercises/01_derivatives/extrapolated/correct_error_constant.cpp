#include "exercise.hpp"

// Finds C, and takes the error of the coarse result away.
double extrapolated(double coarse, double fine, double ratio, int order) {
    const double fine_step = 1, coarse_step = ratio;  // in units of the smaller step
    const double c = (coarse - fine) / (std::pow(coarse_step, order) - std::pow(fine_step, order));
    return coarse - c * std::pow(coarse_step, order);
}
