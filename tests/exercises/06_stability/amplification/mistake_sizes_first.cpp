#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return (1 + (1 - theta) * std::abs(z)) / (1 + theta * std::abs(z));
}
