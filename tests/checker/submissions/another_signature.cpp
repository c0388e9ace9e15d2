// velocity_now does_not_compile: double velocity_now(double x0, double x1, double x2, double h)
#include "exercise.hpp"

double velocity_now(float x0, float x1, float x2, float h) {
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
