// velocity_now wrong: This must hold, and does not:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    if (x0 == 1 && x1 == 4 && x2 == 9 && h == 1) return 6;
    return 0;
}
