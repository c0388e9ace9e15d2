#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs((1 - theta) * (1.0 + z) + theta / (1.0 - z));
}
