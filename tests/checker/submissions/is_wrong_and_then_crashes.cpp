// extrapolated crash: , 2, 6) Line 8:
#include "exercise.hpp"

#include <cstdlib>

double extrapolated(double coarse, double fine, double ratio, int order) {
    if (coarse == fine) return 0;  // wrong, with other ratios than 2
    if (ratio == 2 && order == 6) std::abort();
    const double error_of_coarse = std::pow(ratio, order);
    return (error_of_coarse * fine - coarse) / (error_of_coarse - 1);
}
