// velocity_now pass: Your code printed:
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double x0, double x1, double x2, double h) {
    std::printf("older %g, newer %g\n", (x1 - x0) / h, (x2 - x1) / h);
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
