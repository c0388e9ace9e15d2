#include "exercise.hpp"

double longest_kutta_step(double omega, double zeta) {
    const std::complex<double> fast = -zeta - std::sqrt(std::complex<double>(zeta * zeta - 1));
    double good = 0, bad = 3;
    for (int i = 0; i < 20; ++i) {
        const double wh = (good + bad) / 2;
        const std::complex<double> z = wh * fast;
        (std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0) <= 1 ? good : bad) = wh;
    }
    return good / omega;
}
