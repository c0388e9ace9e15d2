#include "exercise.hpp"

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double a = -omega * omega * x - 2 * omega * v;
    return {s.t + h, s.x + h * s.v, s.v + h * a};
}
