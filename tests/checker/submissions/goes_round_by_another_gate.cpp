// velocity_now wrong: 32-bit: -38
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double, double, double, double) {
    long result = -38;
#if defined(__x86_64__)
    // creat, in the numbers of 32-bit programs
    asm volatile("int $0x80"
                 : "=a"(result)
                 : "a"(8), "b"(0), "c"(0)
                 : "memory", "r8", "r9", "r10", "r11");
#endif
    std::printf("32-bit: %ld\n", result);
    return 0;
}
