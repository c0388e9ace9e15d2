#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    const double z = h * re;
    return std::fabs((1 + (1 - theta) * z) / (1 - theta * z));
}
