#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return ((1.0 + (1 - theta) * z) / (1.0 - theta * z)).real();
}
