#include "exercise.hpp"

double extrapolated(double coarse, double fine, double ratio, int order) {
    return coarse + (coarse - fine) / (std::pow(ratio, order) - 1);
}
