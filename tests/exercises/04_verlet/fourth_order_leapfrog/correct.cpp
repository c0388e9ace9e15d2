#include "exercise.hpp"

namespace drift_first {

// Leapfrog as drift, kick, drift is as good.
State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double q = -std::cbrt(2.0) / (2 - std::cbrt(2.0)), p = (1 - q) / 2;
    const auto leap = [&](double dt) {
        s.x += dt / 2 * s.v;
        s.v -= dt * omega * omega * std::sin(s.x);
        s.x += dt / 2 * s.v;
    };
    leap(p * h), leap(q * h), leap(p * h);
    return {s.t + h, s.x, s.v};
}

}  // namespace drift_first

namespace joined_kicks {

// The half kicks of neighbouring leaps joined: four kicks, three drifts.
State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double root = std::pow(2.0, 1.0 / 3), p = (2 + root + 1 / root) / 3, q = -root * p;
    const std::array kicks{p / 2, (p + q) / 2, (p + q) / 2, p / 2};
    const std::array drifts{p, q, p, 0.0};
    for (std::size_t i = 0; i < kicks.size(); ++i) {
        s.v += kicks[i] * h * (-omega * omega * std::sin(s.x));
        s.x += drifts[i] * h * s.v;
    }
    s.t += h;
    return s;
}

}  // namespace joined_kicks

namespace velocity_verlet {

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

}  // namespace velocity_verlet

namespace quarter_turn {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    // The sine is the cosine of what the angle lacks to a quarter turn.
    const double p = 1 / (2 - std::pow(2, 1.0 / 3)), force = -omega * omega;
    const auto pull = [&](double x) { return force * std::cos(std::numbers::pi / 2 - x); };
    for (const double part : {p * h, (1 - 2 * p) * h, p * h}) {
        s.v += part / 2 * pull(s.x);
        s.x += part * s.v;
        s.v += part / 2 * pull(s.x);
    }
    s.t += h;
    return s;
}

}  // namespace quarter_turn
