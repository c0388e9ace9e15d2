// velocity_now wrong: the call leaves the processor as it found it
#include "exercise.hpp"

#include <cfenv>

double velocity_now(double x0, double x1, double x2, double h) {
    std::fesetround(FE_UPWARD);
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
