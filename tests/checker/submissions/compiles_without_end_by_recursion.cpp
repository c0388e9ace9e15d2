// velocity_now does_not_compile: depth
#include "exercise.hpp"

template <int n>
struct Deeper : Deeper<n + 1> {};

double velocity_now(double, double, double, double) {
    return Deeper<0>().size;
}
