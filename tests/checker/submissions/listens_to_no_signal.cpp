// velocity_now too_slow: waits for what does not come
#include "exercise.hpp"

#include <csignal>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    for (int signal = 1; signal < 65; ++signal) std::signal(signal, SIG_IGN);
    for (;;) pause();
}
