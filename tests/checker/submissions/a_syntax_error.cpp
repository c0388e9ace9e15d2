// velocity_now does_not_compile: error: expected
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    return (x2 - x1) / h
}
