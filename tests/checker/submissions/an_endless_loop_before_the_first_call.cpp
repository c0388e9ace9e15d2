// velocity_now too_slow: before the first call of velocity_now. Is there a loop
#include "exercise.hpp"

const double limit = [] {
    for (volatile bool never = false; !never;) {
    }
    return 2.0;
}();

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
