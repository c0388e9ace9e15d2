// velocity_now crash: Segmentation fault, before the first call of velocity_now Line 6:
#include "exercise.hpp"

double* volatile nowhere = nullptr;
const double limit = [] {
    *nowhere = 1;
    return 2.0;
}();

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
