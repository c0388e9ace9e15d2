#include "exercise.hpp"

// The eigenvalue itself, 1/(1 - i omega h): the logarithm of a size is the real part of the complex
// logarithm, here as a series where it would lose digits.
double implicit_half_life(double omega, double h) {
    const double wh = omega * h, square = wh * wh;
    double rate = -std::log(std::complex<double>(1, -wh)).real() / h;
    if (wh < 1e-2) rate = -(square / 2 - square * square / 4 + std::pow(square, 3) / 6) / h;
    return -std::numbers::ln2 / rate;
}
