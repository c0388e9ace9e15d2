#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    return (2 * x2 - 3 * x1 + x0) / h;
}
