// velocity_now crash: nobody caught: no table, before the first call of velocity_now Line 5:
#include "exercise.hpp"

static double read_table() {
    throw std::runtime_error("no table");
}
const double limit = read_table();

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
