#include "exercise.hpp"

double extrapolated(double coarse, double fine, double ratio, int order) {
    return fine + (fine - coarse) / (ratio - 1);
}
