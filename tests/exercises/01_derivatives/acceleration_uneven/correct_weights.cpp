#include "exercise.hpp"

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    const double sum = h0 + h1;
    return 2 * x0 / (h0 * sum) - 2 * x1 / (h0 * h1) + 2 * x2 / (h1 * sum);
}
