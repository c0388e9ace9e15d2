#include "exercise.hpp"

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - wh * omega * x * v;
    return std::sqrt(twice_energy) / omega;
}
