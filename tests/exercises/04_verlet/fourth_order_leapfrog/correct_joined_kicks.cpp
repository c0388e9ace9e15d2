#include "exercise.hpp"

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
