#include "exercise.hpp"

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
    return {s.t + h, s.x + old * (k1[0] + k2[0]) + own * k3[0],
            s.v + old * (k1[1] + k2[1]) + own * k3[1]};
}
