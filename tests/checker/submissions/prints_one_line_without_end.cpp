// velocity_now wrong: <<<<<<… The same
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double, double, double, double) {
    for (int i = 0; i < 100'000; ++i) std::putchar('<');
    return 0;
}
