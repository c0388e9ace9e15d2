#include "exercise.hpp"

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
