#include "exercise.hpp"

double implicit_half_life(double omega, double h) {
    const double wh = omega * h;
    return std::ceil(2 * std::log(2) / std::log1p(wh * wh)) * h;
}
