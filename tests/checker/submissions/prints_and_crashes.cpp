// velocity_now crash: Your code printed: before the crash
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double x0, double x1, double x2, double h) {
    std::printf("before the crash\n");
    volatile double* nowhere = nullptr;
    *nowhere = x2 - x1;
    return x0 / h;
}
