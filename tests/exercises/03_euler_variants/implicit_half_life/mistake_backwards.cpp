#include "exercise.hpp"

double implicit_half_life(double omega, double h) {
    return std::log(0.5) * h / std::log(std::sqrt(1 + omega * omega * h * h));
}
