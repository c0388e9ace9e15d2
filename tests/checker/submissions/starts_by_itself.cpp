// velocity_now does_not_compile: _start
#include "exercise.hpp"

#include <unistd.h>

extern "C" void _start() {
    _exit(0);
}

double velocity_now(double, double, double, double) {
    return 0;
}
