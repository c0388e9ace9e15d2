#include "exercise.hpp"

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const float gravity = float(g);
    float left = float(h), x = float(s.x), v = float(s.v);
    for (int bounces = 0; bounces < 2000; ++bounces) {
        const float impact = std::sqrt(v * v + 2 * gravity * x);
        const float fall = (v + impact) / gravity;
        if (fall > left)
            return {s.t + h, x + v * left - gravity * left * left / 2, v - gravity * left};
        left -= fall;
        x = 0;
        v = float(e) * impact;
    }
    return {s.t + h, 0, 0};
}
