// velocity_now crash: first line second line \ at 0x12? end
#include "exercise.hpp"

double velocity_now(double, double, double, double) {
    throw std::runtime_error("first line\n\tsecond line \\ at 0x12\r\nend");
}
