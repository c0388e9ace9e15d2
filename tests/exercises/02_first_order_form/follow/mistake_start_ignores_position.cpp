#include "exercise.hpp"

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + (x + v * h) * e, goal_v + (v - omega * (x + v * h)) * e};
}
