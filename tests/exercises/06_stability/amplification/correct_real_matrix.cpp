#include "exercise.hpp"

// y as two real numbers: a complex factor is a 2x2 matrix, whose determinant is the size squared.
double amplification(double re, double im, double theta, double h) {
    const auto determinant = [&](double part) {  // of 1 + part h lambda
        const double xx = 1 + part * h * re, xy = -part * h * im;
        return xx * xx + xy * xy;
    };
    return std::sqrt(determinant(1 - theta) / determinant(-theta));
}
