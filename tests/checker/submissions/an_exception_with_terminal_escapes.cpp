// velocity_now crash: caught: ?[2J??31mright é
#include "exercise.hpp"

double velocity_now(double, double, double, double) {
    throw std::runtime_error("\033[2J\u009b31mright é");
}
