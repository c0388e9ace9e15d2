// velocity_now left_early: The program ended with status 127 instead of returning, in the call
#include "exercise.hpp"

#include <cstdlib>

double velocity_now(double, double, double, double) {
    std::exit(127);
}
