// velocity_now too_slow: before the first call
#include "exercise.hpp"

#include <unistd.h>

extern "C" ssize_t write(int, const void*, size_t size) {
    return static_cast<ssize_t>(size);
}

double velocity_now(double, double, double, double) {
    return 0;
}
