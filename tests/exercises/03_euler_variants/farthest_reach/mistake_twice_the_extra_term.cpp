#include "exercise.hpp"

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - 2 * wh * omega * x * v;
    return std::sqrt(std::fabs(twice_energy) / (1 - wh * wh / 4)) / omega;
}
