// velocity_now does_not_compile: The file has no function
#include "exercise.hpp"

#define double float

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
