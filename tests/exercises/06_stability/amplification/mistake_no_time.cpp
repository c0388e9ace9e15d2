#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> lambda(re, im);
    return std::abs((1.0 + (1 - theta) * lambda) / (1.0 - theta * lambda));
}
