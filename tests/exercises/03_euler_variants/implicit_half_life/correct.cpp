#include "exercise.hpp"

namespace artanh {

// The logarithm of 1 + u is twice the area tangent of u / (2 + u), which loses no digits either.
double implicit_half_life(double omega, double h) {
    const double u = omega * omega * h * h;
    const double shrinks = std::atanh(u / (2 + u));  // the logarithm, per step
    const double per_second = shrinks / h;
    return std::log(2.0) / per_second;
}

}  // namespace artanh

namespace eigenvalue {

// The eigenvalue itself, 1/(1 - i omega h): the logarithm of a size is the real part of the complex
// logarithm, here as a series where it would lose digits.
double implicit_half_life(double omega, double h) {
    const double wh = omega * h, square = wh * wh;
    double rate = -std::log(std::complex<double>(1, -wh)).real() / h;
    if (wh < 1e-2) rate = -(square / 2 - square * square / 4 + std::pow(square, 3) / 6) / h;
    return -std::numbers::ln2 / rate;
}

}  // namespace eigenvalue

namespace ten_digits {

double implicit_half_life(double omega, double h) { return 2 * 0.6931471806 * h / std::log1p(std::pow(omega * h, 2)); }

}  // namespace ten_digits
