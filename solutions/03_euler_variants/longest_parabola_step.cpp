// Chapter 3, exercise 6: how long may this engine's step be?
//
// An engine moves each body along a parabola, which is exact for a thrown ball:
//
//     x2 = x1 + h v1 + h² a1 / 2      v2 = v1 + h a1
//
// where a1 is the acceleration at x1 and v1. You put a door closer into it, a spring with a damper:
// a = -omega² x - 2 zeta omega v. Up to which step is the door stable?
//
//   omega    angular frequency of the spring, rad/s (above zero)
//   zeta     damping ratio, no unit (zero, or from 10⁻⁴ to 20)
//   returns  the h, in seconds, below which every step is stable: whatever the start, the motion
//            dies away. One part in a million off is near enough. Zero where no step is stable.
//
// Example: longest_parabola_step(10, 0.1) is 0.04.
//
// What is checked: a little below it, and far below, a run dies away; a little above it, one grows;
// without damping no step is stable; only omega h and zeta count; weak damping helps, and strong
// damping does harm.

#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    // [answer]
    // The step is a matrix for (x, v/omega). It is stable while both its eigenvalues are within the
    // unit circle; the longest such wh = omega h is found by bisection.
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
    // [answer]
}
