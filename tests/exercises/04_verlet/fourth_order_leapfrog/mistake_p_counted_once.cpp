#include "exercise.hpp"

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}
