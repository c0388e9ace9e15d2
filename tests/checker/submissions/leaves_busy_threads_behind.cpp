// velocity_now wrong: This must hold
#include "exercise.hpp"

#include <thread>

double velocity_now(double, double, double, double) {
    std::thread([] {
        for (volatile int i = 0;; i = i + 1) {
        }
    }).detach();
    return 0;
}
