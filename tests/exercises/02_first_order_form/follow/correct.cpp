#include "exercise.hpp"

namespace product_rule {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    // x = (a + b h) e^(−ωh), and its derivative by the product rule.
    const double a = s.x - goal;
    const double b = s.v - goal_v + omega * a;
    const double e = 1 / std::exp(omega * h);
    const double line = a + b * h;
    return {s.t + h, line * e + (goal + h * goal_v), (b - omega * line) * e + goal_v};
}

}  // namespace product_rule

namespace weights {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    // What a unit of position and a unit of velocity, seen from the player, become.
    const double phase = omega * h, decay = std::exp(-phase);
    const double x = s.x - goal, v = s.v - goal_v;
    State<double> after = s;
    after.t += h;
    after.x = goal + h * goal_v + decay * ((1 + phase) * x + h * v);
    after.v = goal_v + decay * ((1 - phase) * v - omega * phase * x);
    return after;
}

}  // namespace weights

namespace by_change {

// Where it was, and what changes.
State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double off = s.x - goal, faster = s.v - goal_v, phase = omega * h;
    const double slope = faster + omega * off, shrinks = std::expm1(-phase), share = std::exp(-phase);
    const double dx = off * shrinks + (share > 0 ? slope * h * share : 0),
                 dv = faster * shrinks - (share > 0 ? phase * slope * share : 0);
    return {s.t + h, s.x + goal_v * h + dx, s.v + dv};
}

}  // namespace by_change
