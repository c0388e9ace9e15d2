// velocity_now crash: Line 9:
#include "exercise.hpp"

#include <thread>

double velocity_now(double x0, double x1, double x2, double h) {
    volatile double* nowhere = nullptr;
    std::thread([nowhere] {
        *nowhere = 1;
    }).join();
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
