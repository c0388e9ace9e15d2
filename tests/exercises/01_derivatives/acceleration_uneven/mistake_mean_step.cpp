#include "exercise.hpp"

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    const double h = (h0 + h1) / 2;
    return (x2 - 2 * x1 + x0) / (h * h);
}
