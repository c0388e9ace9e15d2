#include "exercise.hpp"

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const auto a = [&](double x) { return -omega * omega * std::sin(x); };
    const double v1 = s.v, a1 = a(s.x);
    const double v2 = s.v + h / 2 * a1, a2 = a(s.x + h / 2 * v1);
    const double v3 = s.v + h / 2 * a2, a3 = a(s.x + h / 2 * v2);
    const double v4 = s.v + h * a3, a4 = a(s.x + h * v3);
    return {s.t + h, s.x + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4),
            s.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}
