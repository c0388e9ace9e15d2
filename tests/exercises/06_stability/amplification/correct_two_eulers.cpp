#include "exercise.hpp"

// The explicit part leads to the middle, and the implicit one on from there.
double amplification(double re, double im, double theta, double h) {
    const std::complex<double> lambda(re, im), y1 = 1;
    const std::complex<double> middle = y1 + (1 - theta) * h * lambda * y1;
    const std::complex<double> y2 = middle / (1.0 - theta * h * lambda);
    return std::abs(y2);
}
