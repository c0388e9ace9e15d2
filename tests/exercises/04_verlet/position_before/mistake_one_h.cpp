#include "exercise.hpp"

double position_before(double x, double v, double a, double h) {
    return x - h * v + h / 2 * a;
}
