#include "exercise.hpp"

double implicit_half_life(double omega, double h) {
    return 2 * std::log(2) / std::log(1 + omega * omega * h * h);
}
