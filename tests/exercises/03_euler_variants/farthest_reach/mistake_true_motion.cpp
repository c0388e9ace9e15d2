#include "exercise.hpp"

double farthest_reach(double x, double v, double omega, double h) {
    return std::sqrt(x * x + v * v / (omega * omega));
}
