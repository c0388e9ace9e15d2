#include "exercise.hpp"

double implicit_half_life(double omega, double h) {
    const double wh = 2 * std::numbers::pi * omega * h;
    return 2 * std::log(2) * h / std::log(1 + wh * wh);
}
