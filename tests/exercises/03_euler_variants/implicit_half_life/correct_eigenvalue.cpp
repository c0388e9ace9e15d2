#include "exercise.hpp"

// The eigenvalue itself: 1/(1 − iωh), a complex number.
double implicit_half_life(double omega, double h) {
    const std::complex<double> lambda = 1.0 / std::complex<double>(1, -omega * h);
    const double rate = std::log2(std::abs(lambda)) / h;  // halvings a second, negative
    return -1 / rate;
}
