#include "exercise.hpp"

double extrapolated(double coarse, double fine, double ratio, int order) {
    double power = 1;
    for (int i = 0; i < order; ++i) power *= ratio;
    return (power * fine - coarse) / (power - 1);
}
