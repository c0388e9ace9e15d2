#include "exercise.hpp"

double extrapolated(double coarse, double fine, double ratio, int order) {
    return (fine - coarse) / (std::pow(ratio, order) - 1);
}
