#include "exercise.hpp"

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
