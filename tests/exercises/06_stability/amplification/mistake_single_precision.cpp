#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    const std::complex<float> z(static_cast<float>(h * re), static_cast<float>(h * im));
    const float t = static_cast<float>(theta);
    return std::abs((1.0f + (1 - t) * z) / (1.0f - t * z));
}
