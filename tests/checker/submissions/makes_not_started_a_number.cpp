// velocity_now wrong: which returned 0
#include "exercise.hpp"

#define not_started 0
#undef NAN
#undef HUGE_VAL

double velocity_now(double, double, double, double) {
    return not_started;
}
