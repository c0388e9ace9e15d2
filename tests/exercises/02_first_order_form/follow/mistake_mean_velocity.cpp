#include "exercise.hpp"

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    if (h == 0) return s;
    const double x = s.x - goal, v = s.v - goal_v;
    const double moved = goal + goal_v * h + (x + (v + omega * x) * h) * std::exp(-omega * h);
    return {s.t + h, moved, (moved - s.x) / h};
}
