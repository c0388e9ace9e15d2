#include "exercise.hpp"

double implicit_half_life(double omega, double h) {
    const double shrinks = 1 / std::sqrt(1 + omega * omega * h * h);
    return std::log(0.5) / std::log(shrinks) * h;
}
