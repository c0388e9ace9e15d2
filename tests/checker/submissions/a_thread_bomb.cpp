// velocity_now crash: Resource temporarily unavailable
#include "exercise.hpp"

#include <thread>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    for (;;)
        std::thread([] {
            for (;;) pause();
        }).detach();
}
