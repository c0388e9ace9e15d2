#include "exercise.hpp"

double extrapolated(double coarse, double fine, double ratio, int order) {
    return (coarse + fine) / 2;
}
