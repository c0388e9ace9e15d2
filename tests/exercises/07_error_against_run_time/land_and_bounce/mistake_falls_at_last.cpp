#include "exercise.hpp"

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double end = s.t + h;
    for (int bounces = 0; bounces <= 1500; ++bounces) {
        const double impact = std::sqrt(s.v * s.v + 2 * g * s.x);
        const double fall = (s.v + impact) / g;
        if (fall > h) return {end, s.x + s.v * h - g * h * h / 2, s.v - g * h};
        h -= fall;
        s = {s.t + fall, 0, e * impact};
    }
    return {end, s.x + s.v * h - g * h * h / 2, s.v - g * h};
}
