// velocity_now crash: index at 0x10 is bad, in the call velocity_now(
#include "exercise.hpp"

double velocity_now(double, double, double, double) {
    throw std::out_of_range("index at 0x10 is bad");
}
