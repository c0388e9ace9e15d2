// velocity_now wrong: e+303
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    double sum;
    sum += (3 * x2 - 4 * x1 + x0) / (2 * h);
    return sum;
}
