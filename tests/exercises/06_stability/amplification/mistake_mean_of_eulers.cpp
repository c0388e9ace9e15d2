#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return (1 - theta) * std::abs(1.0 + z) + theta / std::abs(1.0 - z);
}
