#include "exercise.hpp"

namespace by_hand {

// With w = omega h the trace is 2 - 2 zeta w - w²/2, the determinant 1 - 2 zeta w + w²/2. A pair
// of complex roots leaves where the determinant is 1, at w = 4 zeta, and a real one where
// 1 + trace + determinant = 4 - 4 zeta w is 0.
double longest_parabola_step(double omega, double zeta) {
    return (zeta < 0.5 ? 4 * zeta : 1 / zeta) / omega;
}

}  // namespace by_hand

namespace jury {

// Both roots of lambda² - trace lambda + det lie inside the unit circle where |trace| < 1 + det
// and det < 1. The step doubles until they do not, and then an interval is halved.
double longest_parabola_step(double omega, double zeta) {
    const auto stable = [&](double h) {
        const double k = omega * omega, c = 2 * zeta * omega;
        const double trace = 2 - h * c - h * h * k / 2;
        const double det = 1 - h * c + h * h * k / 2;
        return std::abs(trace) < 1 + det && det < 1;
    };
    double shorter = 0, longer = 1e-6 / omega;
    while (stable(longer)) {
        shorter = longer;
        longer *= 2;
    }
    while (longer - shorter > 1e-9 * longer && longer > 1e-9 / omega) {
        const double between = 0.5 * (shorter + longer);
        if (stable(between))
            shorter = between;
        else
            longer = between;
    }
    return shorter;
}

}  // namespace jury
