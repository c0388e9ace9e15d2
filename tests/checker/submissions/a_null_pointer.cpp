// velocity_now crash: Line 7:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    volatile double* nowhere = nullptr;
    const double rise = x2 - x1;
    *nowhere = rise;
    return rise / h + x0;
}
