// velocity_now crash: Line 2147483600:
#include "exercise.hpp"

static double* volatile nowhere = nullptr;

double velocity_now(double, double, double, double) {
#line 2147483600
    return *nowhere;
}
