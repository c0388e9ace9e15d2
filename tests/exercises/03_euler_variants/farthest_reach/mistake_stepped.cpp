#include "exercise.hpp"

double farthest_reach(double x, double v, double omega, double h) {
    double farthest = std::fabs(x);
    for (int i = 0; i < 1000; ++i) {
        v -= h * omega * omega * x;
        x += h * v;
        farthest = std::fmax(farthest, std::fabs(x));
    }
    return farthest;
}
