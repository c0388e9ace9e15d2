// velocity_now too_slow: no answer in time (2 s of sleep
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    sleep(1000);
    return 0;
}
