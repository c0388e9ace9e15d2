#include "exercise.hpp"

// The kept energy as a sum of two squares: one of x alone, and one that is zero at the farthest x.
double farthest_reach(double x, double v, double omega, double h) {
    const double rest = v - h * omega * omega * x / 2;
    const double stiffness = omega * omega * (1 - h * h * omega * omega / 4);
    return std::sqrt(x * x + rest * rest / stiffness);
}
