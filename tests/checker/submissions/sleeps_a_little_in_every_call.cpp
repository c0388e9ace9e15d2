// velocity_now too_slow: no answer in time (2 s of sleep
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double x0, double x1, double x2, double h) {
    usleep(1'500'000);
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
