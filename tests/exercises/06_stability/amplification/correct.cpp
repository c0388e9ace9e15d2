#include "exercise.hpp"

namespace real_matrix {

// y as two real numbers: a complex factor is a 2x2 matrix, whose determinant is the size squared.
double amplification(double re, double im, double theta, double h) {
    const auto determinant = [&](double part) {  // of 1 + part h lambda
        const double xx = 1 + part * h * re, xy = -part * h * im;
        return xx * xx + xy * xy;
    };
    return std::sqrt(determinant(1 - theta) / determinant(-theta));
}

}  // namespace real_matrix

namespace two_eulers {

// The explicit part leads to the middle, and the implicit one on from there.
double amplification(double re, double im, double theta, double h) {
    const std::complex<double> lambda(re, im), y1 = 1;
    const std::complex<double> middle = y1 + (1 - theta) * h * lambda * y1;
    const std::complex<double> y2 = middle / (1.0 - theta * h * lambda);
    return std::abs(y2);
}

}  // namespace two_eulers

namespace two_sizes {

double amplification(double re, double im, double theta, double h) {
    const double a = h * re, b = h * im, rest = 1 - theta;
    return std::hypot(1 + rest * a, rest * b) / std::hypot(1 - theta * a, theta * b);
}

}  // namespace two_sizes

namespace nearly {

// As far off as the task allows, and not farther.
double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z = std::complex<double>(re, im) * h;
    return (1 + 4e-10) * std::abs(1.0 + (1 - theta) * z) / std::abs(1.0 - theta * z);
}

}  // namespace nearly

namespace one_and_more {

// y2 - y1 is h times the mixed rate, which is lambda y1 / (1 - theta z).
double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z = std::complex<double>(re, im) * h, i = 1.0 - theta * z;
    return std::abs(1.0 + z / i);
}

}  // namespace one_and_more

namespace one_and_a_change {

// What a step adds to 1. Far out it takes nearly all of that 1 away.
double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs(1.0 + z / (1.0 - theta * z));
}

}  // namespace one_and_a_change
