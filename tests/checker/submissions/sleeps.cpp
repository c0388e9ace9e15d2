// velocity_now too_slow: no answer in time
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    sleep(1000);
    return 0;
}
