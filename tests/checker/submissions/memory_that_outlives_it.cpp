// velocity_now wrong: no memory: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <sys/shm.h>

double velocity_now(double, double, double, double) {
    if (shmget(IPC_PRIVATE, 1 << 30, IPC_CREAT | 0600) < 0) std::perror("no memory");
    return 0;
}
