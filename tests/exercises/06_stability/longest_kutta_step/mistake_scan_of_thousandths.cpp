#include "exercise.hpp"

double longest_kutta_step(double omega, double zeta) {
    const std::complex<double> fast = -zeta - std::sqrt(std::complex<double>(zeta * zeta - 1));
    const auto growth = [&](double s) {
        const std::complex<double> z = s * fast;
        return std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0);
    };
    double wh = 0;
    while (wh < 3 && growth(wh + 1e-3) <= 1) wh += 1e-3;
    return wh / omega;
}
