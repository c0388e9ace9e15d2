#include "exercise.hpp"

namespace by_powers {

// R written out, along the ray of the faster decay.
double longest_kutta_step(double omega, double zeta) {
    const std::complex<double> fast = -zeta - std::sqrt(std::complex<double>(zeta * zeta - 1));
    double low = 0, high = 3;
    for (int i = 0; i < 70; ++i) {
        const double middle = (low + high) / 2;
        const std::complex<double> z = middle * fast;
        const double R = std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0);
        (R > 1 ? high : low) = middle;
    }
    return low / omega;
}

}  // namespace by_powers

namespace step_matrix {

// From the step's matrix for (x, v/omega): what it makes of (1, 0) and of (0, 1). Both roots of
// r² - T r + D lie in the unit disk where |T| <= 1 + D and D <= 1.
static bool stable(double zeta, double wh) {
    const auto rate = [&](std::array<double, 2> y) { return std::array{y[1], -y[0] - 2 * zeta * y[1]}; };
    const auto step = [&](double x, double u) {
        const auto k1 = rate({x, u});
        const auto k2 = rate({x + wh / 2 * k1[0], u + wh / 2 * k1[1]});
        const auto k3 = rate({x + wh * (2 * k2[0] - k1[0]), u + wh * (2 * k2[1] - k1[1])});
        return std::array{x + wh / 6 * (k1[0] + 4 * k2[0] + k3[0]), u + wh / 6 * (k1[1] + 4 * k2[1] + k3[1])};
    };
    const auto [xx, ux] = step(1, 0);
    const auto [xu, uu] = step(0, 1);
    const double T = xx + uu, D = xx * uu - xu * ux;
    return std::fabs(T) <= 1 + D && D <= 1;
}

double longest_kutta_step(double omega, double zeta) {
    double low = 0, high = 4;
    for (int i = 0; i < 70; ++i) {
        const double middle = (low + high) / 2;
        if (stable(zeta, middle))
            low = middle;
        else
            high = middle;
    }
    return low / omega;
}

}  // namespace step_matrix

namespace two_cases {

// Swinging: z = omega h (c + i s), and R by its real and its imaginary part. Not swinging: the real
// z where R(z) = -1, by Newton-Raphson.
double longest_kutta_step(double omega, double zeta) {
    if (zeta >= 1) {
        double z = -2.5;
        for (int i = 0; i < 20; ++i) {
            const double R = 1 + z + z * z / 2 + z * z * z / 6, slope = 1 + z + z * z / 2;
            z -= (R + 1) / slope;
        }
        return -z / (omega * (zeta + std::sqrt(zeta - 1) * std::sqrt(zeta + 1)));
    }
    const double c = -zeta, s = std::sqrt(1 - zeta * zeta);
    const auto grows = [&](double r) {
        const double a = r * c, b = r * s;
        const double re = 1 + a + (a * a - b * b) / 2 + (a * a * a - 3 * a * b * b) / 6;
        const double im = b + a * b + (3 * a * a * b - b * b * b) / 6;
        return re * re + im * im > 1;
    };
    double low = 1.5, high = 3;
    while (high - low > 1e-12) {
        const double middle = 0.5 * (low + high);
        (grows(middle) ? high : low) = middle;
    }
    return low / omega;
}

}  // namespace two_cases

namespace nearly {

// As far off as the task allows, and not farther.
double longest_kutta_step(double omega, double zeta) {
    const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1));
    double low = 0, high = 4;
    for (int i = 0; i < 70; ++i) {
        const double middle = (low + high) / 2;
        bool grows = false;
        for (const std::complex<double> z : {middle * (-zeta + root), middle * (-zeta - root)})
            grows |= std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0) > 1;
        (grows ? high : low) = middle;
    }
    return (1 - 3e-8) * low / omega;
}

}  // namespace nearly
