#include "exercise.hpp"

static State<double> fly(const State<double>& s, double g, double h) {
    return {s.t + h, s.x + s.v * h - g * h * h / 2, s.v - g * h};
}
State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    if (s.x <= 0 && s.v <= 0) return fly(s, g, h);
    const double end = s.t + h;
    double left = h;
    for (;;) {
        const double impact = std::sqrt(s.v * s.v + 2 * g * s.x);
        const double fall = (s.v + impact) / g;
        if (fall > left) return {end, s.x + s.v * left - g * left * left / 2, s.v - g * left};
        left -= fall;
        s.x = 0;
        s.v = e * impact;
        if (2 * s.v / g <= (1 - e) * left) return {end, 0, 0};
    }
}
