// velocity_now too_slow: in time (2 s of work
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    volatile bool never = false;
    while (!never) {
    }
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
