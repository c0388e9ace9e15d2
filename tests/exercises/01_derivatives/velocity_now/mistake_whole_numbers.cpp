#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 / 2 * x2 - 2 * x1 + 1 / 2 * x0) / h;
}
