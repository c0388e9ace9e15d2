#include "exercise.hpp"

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double end = s.t + h;
    double left = h;
    for (;;) {
        const double impact = std::sqrt(s.v * s.v + 2 * g * s.x);
        const double fall = (s.v + impact) / g;
        if (fall > left) return {end, s.x + s.v * left - g * left * left / 2, s.v - g * left};
        left -= fall;
        s.x = 0;
        s.v = e * impact;
        if (2 * s.v * e / g <= (1 - e) * left) return {end, 0, 0};
    }
}
