// velocity_now too_slow: waits for what does not come
#include "exercise.hpp"

#include <csignal>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    kill(getppid(), SIGTERM);
    for (;;) pause();
}
