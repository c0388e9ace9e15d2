// velocity_now too_much_memory: before the first call of velocity_now
#include "exercise.hpp"

volatile double grid[200'000'000];

double velocity_now(double x0, double x1, double x2, double h) {
    grid[0] = h;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
