// velocity_now wrong: no file: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <sys/mman.h>

double velocity_now(double, double, double, double) {
    if (memfd_create("memory", 0) < 0) std::perror("no file");
    return 0;
}
