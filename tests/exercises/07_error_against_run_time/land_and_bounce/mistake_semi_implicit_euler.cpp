#include "exercise.hpp"

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    s.v -= g * h;
    s.x += h * s.v;
    if (s.x < 0) s = {s.t, 0, -e * s.v};
    return {s.t + h, s.x, s.v};
}
