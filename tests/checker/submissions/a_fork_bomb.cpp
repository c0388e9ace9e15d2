// velocity_now too_slow: Is there a loop
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    for (;;) fork();
}
