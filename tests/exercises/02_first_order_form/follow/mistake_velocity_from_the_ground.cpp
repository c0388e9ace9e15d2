#include "exercise.hpp"

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + (x + b * h) * e, goal_v + (v - omega * b * h) * e};
}
