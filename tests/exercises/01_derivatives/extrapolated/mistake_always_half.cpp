#include "exercise.hpp"

double extrapolated(double coarse, double fine, double ratio, int order) {
    const double shrinks = std::pow(2, order);
    return fine + (fine - coarse) / (shrinks - 1);
}
