#include "exercise.hpp"

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const auto solve = [&](double part, double x, double v) {
        const double wa = omega * part;
        const double v2 = (v - wa * omega * x) / (1 + 2 * zeta * wa + wa * wa);
        return std::array{x + part * v2, v2};
    };
    const double a = h / 2;
    const double pull = -omega * omega * s.x - 2 * zeta * omega * s.v;
    const auto [x2, v2] = solve(a, s.x + a * s.v, s.v + a * pull);
    return {s.t + h, x2, v2};
}
