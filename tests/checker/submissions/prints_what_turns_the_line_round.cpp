// velocity_now wrong: ??31m ??? ??? ω é
#include "exercise.hpp"

#include <cstdio>

double velocity_now(double, double, double, double) {
    std::puts("\xff\x9b""31m \xe2\x80\xae \xe2\x81\xa6 ω é");
    return 0;
}
