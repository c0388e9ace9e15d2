#include "exercise.hpp"

namespace any_gamma {

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
    const auto [x2, v2] = solve(h / end, (middle * xm - old * s.x) / end, (middle * vm - old * s.v) / end);
    return {s.t + h, x2, v2};
}

}  // namespace any_gamma

namespace rates {

// By the three rates k = f(y), each weighed as the two parts weigh it: h sqrt(2)/4 for the first
// two, gamma h/2 for the last.
State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const double own = h * (1 - std::numbers::sqrt2 / 2), old = h * std::numbers::sqrt2 / 4;
    const auto rate = [&](double x, double v) {  // k = f(y + own k)
        const double a = -(omega * omega * (x + own * v) + 2 * zeta * omega * v) /
                         (1 + 2 * zeta * omega * own + omega * own * omega * own);
        return std::array{v + own * a, a};
    };
    const std::array k1{s.v, -omega * omega * s.x - 2 * zeta * omega * s.v};
    const auto k2 = rate(s.x + own * k1[0], s.v + own * k1[1]);
    const auto k3 = rate(s.x + old * (k1[0] + k2[0]), s.v + old * (k1[1] + k2[1]));
    return {s.t + h, s.x + old * (k1[0] + k2[0]) + own * k3[0], s.v + old * (k1[1] + k2[1]) + own * k3[1]};
}

}  // namespace rates

namespace three_eulers {

// R(z) = (1 + (1 - gamma) z)/(1 - gamma z/2)²: an explicit Euler step and two implicit ones.
State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const double gamma = 2 - std::numbers::sqrt2, part = gamma / 2 * h, rest = (1 - gamma) * h;
    const double pull = -omega * (omega * s.x + 2 * zeta * s.v);
    double x = s.x + rest * s.v, v = s.v + rest * pull;
    const double divisor = 1 + part * omega * (2 * zeta + part * omega);
    for (int i = 0; i < 2; ++i) {
        v = (v - part * omega * omega * x) / divisor;
        x += part * v;
    }
    return {s.t + h, x, v};
}

}  // namespace three_eulers
