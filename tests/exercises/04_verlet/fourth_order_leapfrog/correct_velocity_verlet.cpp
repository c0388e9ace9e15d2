#include "exercise.hpp"

static State<double> velocity_verlet(const State<double>& s, double omega, double h) {
    const double a1 = -omega * omega * std::sin(s.x);
    const double x2 = s.x + h * s.v + h * h / 2 * a1;
    const double a2 = -omega * omega * std::sin(x2);
    return {s.t + h, x2, s.v + h / 2 * (a1 + a2)};
}

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1.3512071919596577718;  // the real root of 2p³ + (1 − 2p)³ = 0
    const State<double> ahead = velocity_verlet(s, omega, p * h);
    const State<double> behind = velocity_verlet(ahead, omega, (1 - 2 * p) * h);
    State<double> end = velocity_verlet(behind, omega, p * h);
    end.t = s.t + h;
    return end;
}
