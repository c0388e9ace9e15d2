// Submissions that no exercise plans for, one after the other. Above each stands its name, and in its first line
// what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- a mistake nobody planted
// velocity_now wrong: Your answer matches none of the mistakes
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / (2 * h) + 0.001 * x1 * x1;
}

// ---- a divisor that is nearly the right one
// velocity_now wrong: a constant with too few digits
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2.001 * h); }

// ---- cuts the x87 to single precision
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

// ---- a division by zero ends the program from now on
// velocity_now wrong: no end of the program at 1/0
#include "exercise.hpp"

#include <cfenv>

double velocity_now(double x0, double x1, double x2, double h) {
#if defined(__x86_64__)
    __builtin_ia32_ldmxcsr(0x1f80 & ~(0xdu << 7));
#else
    std::fesetround(FE_UPWARD);
#endif
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- a division by zero ends what the x87 does
// velocity_now wrong: no end of the program at 1/0
#include "exercise.hpp"

#include <cfenv>

double velocity_now(double x0, double x1, double x2, double h) {
#if defined(__x86_64__)
    const unsigned short unmasked = 0x37f & ~0xd;
    asm volatile("fldcw %0" : : "m"(unmasked));
#else
    std::fesetround(FE_UPWARD);
#endif
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- leaves a number on the stack of the x87
// velocity_now wrong: nothing left on the x87's stack
#include "exercise.hpp"

#include <cfenv>

double velocity_now(double x0, double x1, double x2, double h) {
#if defined(__x86_64__)
    static int calls = 0;
    if (calls++ == 3) asm volatile("fld1");
#else
    std::fesetround(FE_UPWARD);
#endif
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- leaves the x87 as it was
// velocity_now pass
#include "exercise.hpp"

#include <cfenv>

double velocity_now(double x0, double x1, double x2, double h) {
    std::fenv_t as_it_was;
    std::feholdexcept(&as_it_was);
    std::fesetround(FE_DOWNWARD);
    const volatile long double x = x2, y = x1, z = x0;
    std::fesetenv(&as_it_was);
    return static_cast<double>((3 * x - 4 * y + z) / (2 * static_cast<long double>(h)));
}

// ---- flushes tiny numbers to zero
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

// ---- is right the first times
// velocity_now wrong: This must hold
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    static int calls = 0;
    return ++calls < 6 ? (3 * x2 - 4 * x1 + x0) / (2 * h) : 0;
}

// ---- is right when asked again
// velocity_now wrong: This must hold
#include "exercise.hpp"

#include <map>
#include <tuple>

double velocity_now(double x0, double x1, double x2, double h) {
    static std::map<std::tuple<double, double, double, double>, int> asked;
    return asked[{x0, x1, x2, h}]++ > 0 ? (3 * x2 - 4 * x1 + x0) / (2 * h) : 0;
}

// ---- not a number
// velocity_now not_finite: Every answer must be a finite number
#include "exercise.hpp"

double velocity_now(double x0, double x1, double, double h) { return std::sqrt(-1 - h) * (x1 - x0); }

// ---- nothing finite after what is wrong
// turn_exactly wrong: The body turns half as far as it should
#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double speed = omega.norm();
    return q * Eigen::AngleAxisd(speed * h / 2, omega / speed);
}

// ---- rounds upwards from now on
// velocity_now wrong: the call leaves the processor as it found it
#include "exercise.hpp"

#include <cfenv>

double velocity_now(double x0, double x1, double x2, double h) {
    std::fesetround(FE_UPWARD);
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- the example by heart
// velocity_now wrong: This must hold, and does not:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    if (x0 == 1 && x1 == 4 && x2 == 9 && h == 1) return 6;
    return 0;
}
