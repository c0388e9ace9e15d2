// velocity_now wrong: full precision
#include "exercise.hpp"

#include <cfenv>

double velocity_now(double x0, double x1, double x2, double h) {
#if defined(__x86_64__)
    const unsigned short single = 0x007f;
    asm volatile("fldcw %0" : : "m"(single));
#else
    std::fesetround(FE_UPWARD);
#endif
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
