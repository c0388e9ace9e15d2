// velocity_now too_slow: Your code printed: step
#include "exercise.hpp"

#include <iostream>

double velocity_now(double x0, double x1, double x2, double h) {
    std::cout << "step " << h;
    for (volatile bool never = false; !never;) {
    }
    return x0 + x1 + x2;
}
