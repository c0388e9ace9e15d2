#include "exercise.hpp"

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double line = x + (v + omega * x) * h, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + line * e, goal_v - omega * line * e};
}
