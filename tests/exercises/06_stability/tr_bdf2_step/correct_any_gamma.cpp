#include "exercise.hpp"

// By Cramer's rule, and with the parabola's weights for any gamma.
State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const double gamma = 2 - std::sqrt(2.0), k = omega * omega, c = 2 * zeta * omega;
    const auto solve = [&](double p, double X, double V) {  // x - p v = X, p k x + (1 + p c) v = V
        const double det = 1 + p * c + p * p * k;
        return std::pair{(X * (1 + p * c) + p * V) / det, (V - p * k * X) / det};
    };
    const double p = gamma * h / 2;
    const auto [xm, vm] = solve(p, s.x + p * s.v, s.v - p * (k * s.x + c * s.v));
    const double old = (1 - gamma) / gamma, middle = 1 / (gamma * (1 - gamma));
    const double end = (2 - gamma) / (1 - gamma);
    const auto [x2, v2] =
        solve(h / end, (middle * xm - old * s.x) / end, (middle * vm - old * s.v) / end);
    return {s.t + h, x2, v2};
}
