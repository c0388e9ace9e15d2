#include "exercise.hpp"

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    s.v -= h / 2 * omega * omega * std::sin(s.x);
    s.x += h * s.v;
    s.v -= h / 2 * omega * omega * std::sin(s.x);
    return {s.t + h, s.x, s.v};
}
