// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

#include <new>

void* operator new(std::size_t) {
    throw std::bad_alloc();
}

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
