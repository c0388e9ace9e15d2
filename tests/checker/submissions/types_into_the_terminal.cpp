// velocity_now wrong: no terminal: No such device or address
#include "exercise.hpp"

#include <cstdio>

#include <fcntl.h>

double velocity_now(double, double, double, double) {
    if (open("/dev/tty", O_RDONLY) < 0) std::perror("no terminal");
    return 0;
}
