#include "exercise.hpp"

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
