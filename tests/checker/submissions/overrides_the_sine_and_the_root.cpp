// velocity_now wrong: This must hold
#include "exercise.hpp"

extern "C" double sin(double) noexcept {
    return 0;
}
extern "C" double sqrt(double) noexcept {
    return 0;
}
extern "C" double fabs(double) noexcept {
    return 0;
}

double velocity_now(double, double, double, double) {
    return 0;
}
