#include "exercise.hpp"

namespace by_bisection {

// The step is a matrix for (x, v/omega). It is stable while both its eigenvalues are within the
// unit circle; the longest such wh = omega h is found by bisection.
double longest_parabola_step(double omega, double zeta) {
    const auto stable = [&](double wh) {
        const double xx = 1 - wh * wh / 2, xv = wh - zeta * wh * wh;
        const double vx = -wh, vv = 1 - 2 * zeta * wh;
        const std::complex<double> half = (xx + vv) / 2;
        const std::complex<double> root = std::sqrt(half * half - (xx * vv - xv * vx));
        return std::max(std::abs(half + root), std::abs(half - root)) < 1;
    };
    double good = 0, bad = 4;  // beyond wh = 4 every oscillation has left, whatever the damping
    for (int i = 0; i < 60; ++i) {
        const double middle = (good + bad) / 2;
        (stable(middle) ? good : bad) = middle;
    }
    return good / omega;
}

}  // namespace by_bisection

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
