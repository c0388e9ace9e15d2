#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    const double z = h * std::hypot(re, im);
    return std::fabs((1 + (1 - theta) * z) / (1 - theta * z));
}
