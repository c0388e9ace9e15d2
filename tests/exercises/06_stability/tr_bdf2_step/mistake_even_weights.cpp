#include "exercise.hpp"

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const double gamma = 2 - std::sqrt(2.0), a = gamma * h / 2;
    const auto acceleration = [&](double x, double v) {
        return -omega * omega * x - 2 * zeta * omega * v;
    };
    // The y with y - part f(y) = (x, v).
    const auto solve = [&](double part, double x, double v) {
        const double wa = omega * part;
        const double v2 = (v - wa * omega * x) / (1 + 2 * zeta * wa + wa * wa);
        return std::array{x + part * v2, v2};
    };
    const auto [xm, vm] = solve(a, s.x + a * s.v, s.v + a * acceleration(s.x, s.v));
    const double w = 4.0 / 3, a2 = h / 3;
    const auto [x2, v2] = solve(a2, s.x + w * (xm - s.x), s.v + w * (vm - s.v));
    return {s.t + h, x2, v2};
}
