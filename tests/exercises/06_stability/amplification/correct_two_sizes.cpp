#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    const double a = h * re, b = h * im, rest = 1 - theta;
    return std::hypot(1 + rest * a, rest * b) / std::hypot(1 - theta * a, theta * b);
}
