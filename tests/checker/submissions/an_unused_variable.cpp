// velocity_now pass: The compiler remarks:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    const double middle = (x2 - x0) / 2;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
