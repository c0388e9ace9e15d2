// velocity_now wrong: no tiny number flushed to zero
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
#if defined(__x86_64__)
    __builtin_ia32_ldmxcsr(0x9fc0);
#elif defined(__aarch64__)
    __builtin_aarch64_set_fpcr(1u << 24);
#endif
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
