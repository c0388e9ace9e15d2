#include "exercise.hpp"

double implicit_half_life(double omega, double h) {
    return std::log(2) * h / std::log(1 + omega * omega * h * h);
}
