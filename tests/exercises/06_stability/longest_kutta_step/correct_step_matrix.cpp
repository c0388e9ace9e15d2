#include "exercise.hpp"

// From the step's matrix for (x, v/omega): what it makes of (1, 0) and of (0, 1). Both roots of
// r² - T r + D lie in the unit disk where |T| <= 1 + D and D <= 1.
static bool stable(double zeta, double wh) {
    const auto rate = [&](std::array<double, 2> y) {
        return std::array{y[1], -y[0] - 2 * zeta * y[1]};
    };
    const auto step = [&](double x, double u) {
        const auto k1 = rate({x, u});
        const auto k2 = rate({x + wh / 2 * k1[0], u + wh / 2 * k1[1]});
        const auto k3 = rate({x + wh * (2 * k2[0] - k1[0]), u + wh * (2 * k2[1] - k1[1])});
        return std::array{x + wh / 6 * (k1[0] + 4 * k2[0] + k3[0]),
                          u + wh / 6 * (k1[1] + 4 * k2[1] + k3[1])};
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
